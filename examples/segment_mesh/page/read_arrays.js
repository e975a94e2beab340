"use strict";

/// The arrays by name: \c index of page_data(), and the bytes. Those of type Int32Array hold differences.
function readArrays(index, bytes) {
  const types = {Float32Array, Uint32Array, Int32Array}, arrays = {};
  let offset = 0;
  for (const {name, type, length} of index) {
    arrays[name] = new types[type](bytes, offset, length);
    if (type === "Int32Array") {
      arrays[name] = new Uint32Array(arrays[name]);
      for (let i = 1; i < length; ++i) arrays[name][i] += arrays[name][i - 1];
    }
    offset += 4 * length;
  }
  return arrays;
}
