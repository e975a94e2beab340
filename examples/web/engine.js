"use strict";

class Cancelled extends Error {}

// The library in a worker. It holds one mesh, the last that was opened.
class Engine {
  /// \param source a script: emscripten's and worker.js
  /// \param report hears of a stage and of how much of it is done, from 0 to 1
  constructor(source, report) {
    this.url = URL.createObjectURL(new Blob([source], {type: "text/javascript"}));
    this.report = report;
    this.start();
  }

  start() {
    this.opened = null;
    this.calls = []; // without an answer, in their order
    this.worker = new Worker(this.url);
    this.worker.onmessage = ({data}) => this.hear(data);
    this.worker.onerror = event => this.stop(new Error(event.message));
  }

  hear(message) {
    if (message.stage) return this.report(message.stage, message.fraction);
    const {resolve, reject} = this.calls.shift();
    if (message.error) reject(new Error(message.error));
    else resolve(message);
    if (message.isBroken) this.stop(new Error(message.error));
  }

  stop(error) {
    this.worker.terminate();
    const calls = this.calls;
    this.start();
    for (const {reject} of calls) reject(error);
  }

  cancel() { this.stop(new Cancelled("cancelled")); }

  /// The answer to a call on a file, see worker.js.
  async run(file, call, ...values) {
    if (this.opened !== file) {
      this.opened = null;
      await this.ask("open", file.name, await file.arrayBuffer());
      this.opened = file;
    }
    return this.ask(call, ...values);
  }

  ask(call, ...values) {
    return new Promise((resolve, reject) => {
      this.calls.push({resolve, reject});
      this.worker.postMessage({call, values});
    });
  }
}
