"use strict";

// Shows the mesh that a program has saved in the page.

async function inflate(base64) {
  const text = atob(base64), compressed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) compressed[i] = text.charCodeAt(i);
  return new Response(new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

(async () => {
  try {
    const content = JSON.parse(element("content").textContent);
    const arrays = readArrays(content.arrays, await inflate(element("arrays").textContent));
    element("arrays").remove();
    const page = new Page();
    page.show(content, arrays);
    window.page = page;
  } catch (error) {
    fail(typeof DecompressionStream === "undefined" ? "This page needs a browser of 2023 or later."
      : "The mesh cannot be shown: " + error.message);
  }
})();
