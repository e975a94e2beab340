// SPDX-License-Identifier: GPL-3.0-or-later

// node npm_test.mjs SEGMENT_MESH FOLDER [MESH.off...]: the installed package gives the labels of the native program.

import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {readFileSync, writeFileSync} from "node:fs";
import {test} from "node:test";
import {findPartFaces, segment, Segmenter} from "region-segmentation";

const [program, folder, ...meshes] = process.argv.slice(2);
const labelsOf = file => readFileSync(file, "utf8").trim().split("\n").map(Number);

// Colors may follow the corners of a face.
function readOff(file) {
  const [, [n, m], ...rows] = readFileSync(file, "utf8").split("\n").map(line => line.trim().split(/\s+/).map(Number))
    .filter(row => row.length > 1 || Number.isNaN(row[0]));
  return {points: rows.slice(0, n), faces: rows.slice(n, n + m).map(([size, ...row]) => row.slice(0, size))};
}

const runs = [["learned"], ["learned", 7], ["visibility", 5], ["two-step", 6], ["smooth-faces"]];

for (const mesh of meshes)
  for (const [method, numberOfSegments] of runs)
    test(`${mesh} ${method} ${numberOfSegments ?? ""}`, async () => {
      const labels = `${folder}/labels.seg`;
      const number = numberOfSegments ? ["-k", numberOfSegments] : [];
      execFileSync(program, [mesh, "-q", "--method", method, ...number, "-o", labels]);
      const {points, faces} = readOff(mesh);
      assert.deepEqual([...await segment(points, faces, {method, numberOfSegments})], labelsOf(labels));
    });

// A strip of n squares in the plane.
function strip(n) {
  const points = [], faces = [];
  for (let i = 0; i <= n; ++i) points.push([i, 0, 0], [i, 1, 0]);
  for (let i = 0; i < n; ++i) faces.push([2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]);
  return {points, faces};
}

test("arrays of other forms", async () => {
  const {points, faces} = strip(6);
  const triangles = faces.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);
  const expected = await segment(points, triangles, {numberOfSegments: 3});
  assert.equal(Math.max(...expected), 2);
  for (const p of [points.flat(), new Float32Array(points.flat()), points.map(x => new Float64Array(x))])
    for (const f of [triangles.flat(), new Uint16Array(triangles.flat()), triangles.map(x => new Int32Array(x))])
      assert.deepEqual(await segment(p, f, {numberOfSegments: 3}), expected);
  assert.ok(expected instanceof Uint32Array);
});

test("prepared once", async () => {
  const {points, faces} = strip(6);
  const segmenter = await Segmenter.create(points, faces, {method: "visibility"});
  for (const numberOfSegments of [2, 4, undefined])
    assert.deepEqual(segmenter.segment(numberOfSegments), await segment(points, faces, {method: "visibility", numberOfSegments}));
  assert.throws(() => segmenter.segment(1.5), /^TypeError: numberOfSegments: not/);
  segmenter.free();
  assert.throws(() => segmenter.segment(2));
});

test("the examples of the README", async () => {
  const [first, second] = [...readFileSync("node_modules/region-segmentation/README.md", "utf8").matchAll(/```js\n(.*?)```/gs)];
  writeFileSync("example.mjs", first[1]);
  assert.equal(execFileSync("node", ["example.mjs"], {encoding: "utf8"}).match(/Uint32Array\(4\)/g).length, 3);
  writeFileSync("holes.mjs", `const [points, triangles] = ${JSON.stringify(tube(2, 1, 24))};\n${second[1]}`);
  const [, radius] = execFileSync("node", ["holes.mjs"], {encoding: "utf8"}).match(/^cylinder (\S+) /);
  assert.ok(Math.abs(radius - 1) < 1e-9, radius);
});

// A tube round the z axis, of height 1, in quads.
function tube(outer, inner, n) {
  const profile = [[inner, 0], [outer, 0], [outer, 1], [inner, 1]], points = [], faces = [];
  profile.forEach(([r, z], i) => {
    for (let j = 0; j < n; ++j) {
      points.push([r * Math.cos(2 * Math.PI * j / n), r * Math.sin(2 * Math.PI * j / n), z]);
      const [next, up] = [(j + 1) % n, (i + 1) % 4 * n];
      faces.push([i * n + j, i * n + next, up + next, up + j]);
    }
  });
  return [points, faces];
}

test("the faces of a machine part", async () => {
  const [points, quads] = tube(2, 1, 48), {labels, faces} = await findPartFaces(points, quads);
  assert.deepEqual([...labels], [...await segment(points, quads, {method: "smooth-faces"})]);
  assert.deepEqual(faces.map(face => face.surface.type), ["plane", "cylinder", "plane", "cylinder"]);
  assert.deepEqual(faces.map(face => [face.role, face.isConcave, face.firstOnAxis]),
                   [[undefined, false, 0], [undefined, false, 1], [undefined, false, 2], ["hole", true, 1]]);
  const {radius, point, direction, extent, deviation, halfAngle} = faces[3].surface;
  const along = extent.map(t => point[2] + t * direction[2]).sort();
  for (const [found, expected] of [[radius, 1], [along[0], 0], [along[1], 1], [deviation, 0], [point[0], 0]])
    assert.ok(Math.abs(found - expected) < 1e-9, `${found} ${expected}`);
  assert.equal(halfAngle, undefined);
  assert.deepEqual(faces[0].neighbors.map(({face, isSmooth}) => [face, isSmooth]), [[1, false], [3, false]]);
  await assert.rejects(findPartFaces(points, quads, {tolerance: -1}), /^TypeError: tolerance: not/);
  await assert.rejects(findPartFaces([[NaN, 0, 0], ...points.slice(1)], quads), /vertex 0 is not finite/);
  assert.equal(new Set((await findPartFaces(points, quads, {tolerance: 3})).labels).size, 1);
});

test("constraints and seeds", async () => {
  const {points, faces} = strip(6);
  assert.deepEqual([...await segment(points, faces, {numberOfSegments: 1, constrainedEdges: [[4, 5]]})], [0, 0, 1, 1, 1, 1]);
  const labels = await segment(points, faces, {numberOfSegments: 2, seeds: [0, 1, 1, 1, 1, 1]});
  assert.deepEqual([...labels], [0, 1, 1, 1, 1, 1]);
});

test("links of components", async () => {
  const a = strip(2), b = strip(2);
  const points = [...a.points, ...b.points.map(([x, y, z]) => [x + 2.1, y, z])];
  const faces = [...a.faces, ...b.faces.map(face => face.map(i => i + a.points.length))];
  assert.deepEqual([...await segment(points, faces, {numberOfSegments: 1})], [0, 0, 0, 0]);
  assert.deepEqual([...await segment(points, faces, {numberOfSegments: 1, componentLinks: false})], [0, 0, 1, 1]);
});

test("errors name the place", async () => {
  const {points, faces} = strip(6);
  const error = async (...values) => (await segment(...values).then(() => assert.fail("no error"), e => e)).message;
  assert.equal(await error(points, [...faces, [0, 1, 99]]), "face 6, from 0: index 99 is out of range: there are 14 points");
  assert.equal(await error(points, [0, 1, 2, 3, -1, 5]), "face 1, from 0: index -1 is out of range: there are 14 points");
  assert.equal(await error(points, [[0, 1, 2], []]), "face 1, from 0: has no corners");
  assert.match(await error([...points, [0, 1]], faces), /^points: not/);
  assert.match(await error(points, faces, {numberOfSegments: 0}), /^numberOfSegments: not/);
  assert.match(await error(points, faces, {method: "x"}), /^method: not/);
  assert.match(await error(points, faces, {method: "two-step"}), /needs the number of segments/);
  assert.match(await error(points, faces, {constrainedEdges: [[0, 13]]}), /no edge between points 0 and 13/);
  assert.match(await error(points, [0, 1, 1.5]), /index 1.5 is out of range/);
  for (const seeds of [[1], null, faces.map(() => 0.5)]) assert.match(await error(points, faces, {seeds}), /^seeds: not/);
  for (const method of [null, 3]) assert.match(await error(points, faces, {method}), /^method: not/);
  assert.match(await error(points, [[0, 1, 2], 3]), /^faces: not/);
  assert.equal(await error([[NaN, 0, 0], ...points.slice(1)], faces), "the point of vertex 0 is not finite");
});
