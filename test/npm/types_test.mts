// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled only: what the types allow, and what they refuse.

import {findPartFaces, segment, Segmenter, Options} from "region-segmentation";

const points = new Float32Array(9);
const options: Options = {method: "two-step", numberOfSegments: 2, constrainedEdges: [[0, 1]]};
const labels: Promise<Uint32Array> = segment(points, [[0, 1, 2]], options);
segment([[0, 0, 0], new Float64Array(3)], new Uint32Array(3), {seeds: new Int32Array(1)});
const again: Promise<Uint32Array> = Segmenter.create(points, [[0, 1, 2]]).then(segmenter => segmenter.segment(2));

const radii: Promise<(number | undefined)[]> = findPartFaces(points, [[0, 1, 2]], {tolerance: 0.1})
  .then(({faces}) => faces.map(face => face.surface.radius));

// @ts-expect-error: create() is asynchronous
new Segmenter();
// @ts-expect-error: no method
segment(points, [[0, 1, 2]], {method: "spectral"});
// @ts-expect-error: no option
segment(points, [[0, 1, 2]], {number: 2});
// @ts-expect-error: no faces
segment(points);
// @ts-expect-error: a promise
const array: Uint32Array = labels;
