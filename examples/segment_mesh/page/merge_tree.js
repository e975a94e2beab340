"use strict";

// The merge tree: its nodes are the regions, 0 to R - 1, then the result of each merge, and of each join that the user
// makes. A segmentation is a list of nodes.
class MergeTree {
  constructor(numberOfRegions, merges, areas, firstFaces) {
    this.numberOfRegions = numberOfRegions;
    this.children = new Array(numberOfRegions).fill(null);
    this.areas = Array.from(areas);
    this.firstFaces = Array.from(firstFaces); // Infinity of a region without faces
    this.parents = new Array(numberOfRegions).fill(Infinity);
    const nodeOfRegion = Array.from({length: numberOfRegions}, (_, region) => region);
    for (let i = 0; i < merges.length; i += 2) {
      const [kept, removed] = [merges[i], merges[i + 1]];
      nodeOfRegion[kept] = this.join(nodeOfRegion[kept], nodeOfRegion[removed]);
    }
    this.numberOfNodes = this.children.length; // without joins of the user
  }

  get least() { return 2 * this.numberOfRegions - this.numberOfNodes; }

  /// A new node.
  join(a, b) {
    const node = this.children.length;
    this.children.push([a, b]);
    this.parents.push(Infinity);
    this.areas.push(this.areas[a] + this.areas[b]);
    this.firstFaces.push(Math.min(this.firstFaces[a], this.firstFaces[b]));
    if (this.parents[a] === Infinity) this.parents[a] = node;
    if (this.parents[b] === Infinity) this.parents[b] = node;
    return node;
  }

  /// The two nodes that have faces below a node, null of a region.
  split(node) {
    while (this.children[node]) {
      const parts = this.children[node].filter(child => this.firstFaces[child] !== Infinity);
      if (parts.length === 2) return parts;
      node = parts[0];
    }
    return null;
  }

  /// The nodes of the partition into a number of segments, by their first faces.
  partition(number) {
    const end = 2 * this.numberOfRegions - number;
    const nodes = [];
    for (let node = 0; node < Math.min(end, this.numberOfNodes); ++node)
      if (!(this.parents[node] < Math.min(end, this.numberOfNodes)) && this.firstFaces[node] !== Infinity) nodes.push(node);
    return this.sorted(nodes);
  }

  sorted(nodes) { return nodes.slice().sort((a, b) => this.firstFaces[a] - this.firstFaces[b]); }

  larger(a, b) { return this.areas[b] > this.areas[a] ? b : a; }

  forEachRegion(node, visit) {
    const open = [node];
    while (open.length > 0) {
      const top = open.pop();
      if (this.children[top]) open.push(...this.children[top]);
      else visit(top);
    }
  }

  /// A color for each node: those of the first partition are 0, 1, ...; the larger part of a split, and what is joined from it,
  /// keep the color.
  colors(firstPartition) {
    const colors = new Array(this.numberOfNodes).fill(0);
    firstPartition.forEach((node, i) => { colors[node] = i; });
    let next = firstPartition.length;
    const isBelow = new Array(this.numberOfNodes).fill(false);
    firstPartition.forEach(node => { isBelow[node] = true; });
    for (let node = this.numberOfNodes - 1; node >= this.numberOfRegions; --node) {
      if (!isBelow[node]) continue;
      const [a, b] = this.children[node];
      const larger = this.larger(a, b);
      colors[larger] = colors[node];
      colors[larger === a ? b : a] = next++;
      isBelow[a] = isBelow[b] = true;
    }
    for (let node = this.numberOfRegions; node < this.numberOfNodes; ++node)
      if (!isBelow[node]) colors[node] = colors[this.larger(...this.children[node])];
    return colors;
  }
}
