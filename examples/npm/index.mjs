// SPDX-License-Identifier: LGPL-3.0-or-later

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

function meshOf(points, faces) {
  const mesh = {points: flat(points, 3, "points: not an array of 3 coordinates each")};
  if (Array.isArray(faces) && faces.length > 0 && faces.every(isArray))
    return {...mesh, corners: faces.flatMap(face => [...face]), sizes: faces.map(face => face.length)};
  const corners = flat(faces, 3, "faces: not an array of faces, nor of the indices of triangles");
  return {...mesh, corners, sizes: new Uint32Array(corners.length / 3).fill(3)};
}

/// The engine answers with a text where it fails.
function valueOf(answer) {
  if (typeof answer === "string") throw new Error(answer);
  return answer;
}

const loadEngine = () => engine ??= makeEngine();

/// See index.d.ts.
export async function findPartFaces(points, faces, {tolerance = 0} = {}) {
  check(Number.isFinite(tolerance) && tolerance >= 0, "tolerance: not a finite length of at least 0");
  const {labels, faces: json} = valueOf((await loadEngine()).findPartFaces({...meshOf(points, faces), tolerance}));
  return {labels, faces: JSON.parse(json.replace(/_(.)(?=\w*":)/g, (_, letter) => letter.toUpperCase()))}; // camel case
}

/// See index.d.ts.
export class Segmenter {
  #prepared;

  static async create(points, faces, {method = "learned", constrainedEdges = [], seeds = [],
    componentLinks = true} = {}) {
    const mesh = meshOf(points, faces);
    check(isArray(seeds) && [0, mesh.sizes.length].includes(seeds.length) && seeds.every(Number.isInteger),
      "seeds: not an integer for each face, -1 for none");
    const pairs = flat(constrainedEdges, 2, "constrainedEdges: not pairs of indices of points");
    const request = {...mesh, constrainedEdges: pairs, seeds, componentLinks};
    const segmenter = new Segmenter();
    segmenter.#prepared = valueOf((await loadEngine()).prepare(String(method), request));
    return segmenter;
  }

  segment(numberOfSegments) {
    check(numberOfSegments === undefined ||
      (Number.isInteger(numberOfSegments) && numberOfSegments >= 1),
      "numberOfSegments: not an integer from 1 on");
    return valueOf(this.#prepared.segment(numberOfSegments ?? 0));
  }

  free() {
    this.#prepared.delete();
  }
}

export async function segment(points, faces, options = {}) {
  const segmenter = await Segmenter.create(points, faces, options);
  try {
    return segmenter.segment(options.numberOfSegments);
  } finally {
    segmenter.free();
  }
}
