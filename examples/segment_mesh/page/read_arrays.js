"use strict";

/// The arrays by name: \c index of page_data(), and the bytes.
function readArrays(index, bytes) {
  const types = {Float32Array, Uint32Array}, arrays = {};
  let offset = 0;
  for (const {name, type, length} of index) {
    arrays[name] = new types[type](bytes, offset, length);
    offset += 4 * length;
  }
  return arrays;
}
