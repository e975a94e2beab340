
// What follows the code of emscripten in the worker: answers the calls of engine.js, one after the other.

const engine = makeEngine();

async function inflated(bytes) {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer().catch(() => {
    throw new Error("the file is a gzip file that is damaged or cut off");
  }));
}

const calls = {
  open: async (name, bytes) => (await engine).open(name, await inflated(new Uint8Array(bytes))),
  segment: async request => (await engine).segment(request, (stage, fraction) => postMessage({stage, fraction})),
  describe: async nodes => (await engine).describe(nodes),
  write: async (...values) => (await engine).write(...values)
};

let last = Promise.resolve();
onmessage = ({data: {call, values}}) => {
  last = last.then(() => calls[call](...values)).then(answer => postMessage(answer), error => {
    // A trap leaves the module in no state to go on.
    const isBroken = error instanceof WebAssembly.RuntimeError;
    postMessage({error: isBroken ? "not enough memory in the browser, or a fault: " + error.message : error.message, isBroken});
  });
};
