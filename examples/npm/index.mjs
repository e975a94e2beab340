// SPDX-License-Identifier: GPL-3.0-or-later

import makeEngine from "./engine.mjs";

let engine;

function check(isRight, what) {
  if (!isRight) throw new TypeError(what);
}

const isArray = value => Array.isArray(value) || ArrayBuffer.isView(value);

/// The numbers of rows of `width`, or of one array of them all.
function flat(values, width, what) {
  check(isArray(values), what);
  const isNested = values.length > 0 && isArray(values[0]);
  check(isNested ? values.every(row => row.length === width) : values.length % width === 0, what);
  return isNested ? values.flatMap(row => [...row]) : values;
}

/// Indices below `count`; `place` of its position says where another one is.
function checkIndices(indices, count, place) {
  indices.forEach((index, i) => {
    if (!Number.isInteger(index) || index < 0 || index >= count)
      throw new RangeError(
        `${place(i)}: index ${index} is out of range: there are ${count} points`);
  });
}

function facesOf(faces, numberOfPoints) {
  const isRagged = Array.isArray(faces) && faces.length > 0 && isArray(faces[0]);
  const corners = isRagged ? faces.flatMap(face => [...face])
    : flat(faces, 3, "faces: not an array of faces, nor of the indices of triangles");
  const sizes = isRagged ? faces.map(face => face.length)
    : new Uint32Array(corners.length / 3).fill(3);
  const faceOfCorner = i => {
    let f = 0;
    while (i >= sizes[f]) i -= sizes[f++];
    return `face ${f}, from 0`;
  };
  check(!sizes.includes(0), `face ${sizes.indexOf(0)}, from 0: has no corners`);
  checkIndices(corners, numberOfPoints, faceOfCorner);
  return {corners, sizes};
}

/// The segment of each face, 0 to n - 1 in the order of their first faces: see index.d.ts.
export async function segment(points, faces, options = {}) {
  const coordinates = flat(points, 3, "points: not an array of 3 coordinates each");
  const numberOfPoints = coordinates.length / 3;
  const {numberOfSegments = 0, method = "learned", constrainedEdges = [], seeds = [],
    componentLinks = true} = options;
  check(options.numberOfSegments === undefined ||
    (Number.isInteger(numberOfSegments) && numberOfSegments >= 1),
    "numberOfSegments: not an integer from 1 on");
  const {corners, sizes} = facesOf(faces, numberOfPoints);
  const edges = flat(constrainedEdges, 2, "constrainedEdges: not pairs of indices of points");
  checkIndices(edges, numberOfPoints, () => "constrainedEdges");
  check(seeds.length === 0 || seeds.length === sizes.length,
    "seeds: not an integer for each face, -1 for none");

  engine ??= makeEngine();
  const result = (await engine).segment(method, {
    points: coordinates, corners, sizes, numberOfSegments, constrainedEdges: edges, seeds,
    componentLinks
  });
  if (typeof result === "string") throw new Error(result);
  return result;
}
