"use strict";

// What the user sees and does beside the mesh.

const element = id => document.getElementById(id);

function fail(message) {
  element("failure").textContent = message;
  element("failure").hidden = false;
}

/// Three significant digits, and no exponent where that is readable.
function number(x) {
  if (x === null || !isFinite(x)) return "–";
  if (x === 0) return "0";
  return Math.abs(x) >= 1e6 || Math.abs(x) < 1e-4 ? x.toExponential(2) : String(Number(x.toPrecision(3)));
}

const counted = (n, noun) => n.toLocaleString("en") + " " + noun + (n === 1 ? "" : "s");
const percent = part => part >= 0.9995 ? "100 %" : part >= 0.001 ? (100 * part).toFixed(1) + " %" : "< 0.1 %";

/// Of kinds of surface, as in pictures: far apart also for most color-blind eyes.
const kindColors = {plane: [68, 119, 170], cylinder: [238, 102, 119], cone: [34, 136, 51], sphere: [204, 187, 68],
                    torus: [102, 204, 238], freeform: [170, 51, 119],
                    "other surface": [187, 187, 187], "not described": [235, 236, 240]};

class Page {
  constructor() {
    this.view = new MeshView(element("view"));
    this.tool = "select";
    this.listen();
  }

  /// \param content, arrays what page_data() gives
  show(content, arrays) {
    this.view.setMesh(arrays, content.view);
    this.showSegmentation(content, arrays);
  }

  /// Another segmentation of the mesh that is shown.
  showSegmentation(content, arrays) {
    this.content = content;
    this.arrays = arrays;
    const firstFaces = new Float64Array(content.regions).fill(Infinity);
    this.facesOfRegion = new Uint32Array(content.regions);
    arrays.regions.forEach((region, face) => {
      firstFaces[region] = Math.min(firstFaces[region], face);
      ++this.facesOfRegion[region];
    });
    if (content.none !== null) firstFaces[content.none] = Number.MAX_VALUE; // no segment: after all of them
    this.tree = new MergeTree(content.regions, arrays.merges, arrays.areas, firstFaces);
    this.totalArea = arrays.areas.reduce((sum, area) => sum + area, 0) || 1;
    this.shapes = new Map();
    this.addShapes(content.shapes || []);
    const first = this.tree.partition(content.segments);
    this.colors = this.tree.colors(first);
    this.names = new Map(content.names.map((name, i) => [first[i], name]));
    if (content.coloring) element("coloring").value = content.coloring;
    this.view.setRegions(arrays.regions, content.regions);
    this.history = [];
    this.future = [];
    this.isHidden = new Uint8Array(content.regions);
    this.hovered = this.selected = this.firstToJoin = null;
    this.describeMesh();
    this.setNodes(first);
    this.setTool(this.tool);
  }

  addShapes(shapes) {
    for (const shape of shapes) this.shapes.set(shape.node, shape);
  }

  describeMesh() {
    const {content, tree} = this;
    document.title = content.name.replace(/.*[/\\]/, "") + " – segments";
    element("name").textContent = content.name.replace(/.*[/\\]/, "");
    element("name").title = content.name;
    element("summary").textContent = counted(this.arrays.regions.length, "face") + " · " + counted(content.regions, "region");
    const slider = element("slider"), count = element("count");
    slider.min = count.min = tree.least - this.otherNodes;
    slider.max = Math.max(content.greatest, slider.min);
    count.max = content.regions - this.otherNodes;
    slider.disabled = count.disabled = tree.least === content.regions;
    element("least").textContent = slider.min;
    element("greatest").textContent = slider.max;
  }

  // The segmentation.

  /// The nodes of a partition that are no segments: one with the faces of no segment, if there are any.
  get otherNodes() { return this.content.none === null ? 0 : 1; }

  setNodes(nodes) {
    this.nodes = nodes;
    this.segmentOfRegion = new Uint32Array(this.content.regions);
    nodes.forEach((node, segment) => this.tree.forEachRegion(node, region => { this.segmentOfRegion[region] = segment; }));
    for (const name of ["hovered", "selected", "firstToJoin"])
      if (!nodes.includes(this[name])) this[name] = null;
    element("slider").value = element("count").value = nodes.length - this.otherNodes;
    element("undo").disabled = this.history.length === 0;
    element("redo").disabled = this.future.length === 0;
    this.measure();
    this.explode();
    this.list();
    this.paint();
  }

  explode() { this.view.explode(Number(element("explosion").value), this.segmentOfRegion); }

  /// Sums over the regions of each segment.
  measure() {
    this.measures = this.nodes.map(node => ({area: this.tree.areas[node], faces: 0, border: 0, neighbors: new Map()}));
    this.facesOfRegion.forEach((faces, region) => { this.measures[this.segmentOfRegion[region]].faces += faces; });
    const {sections, lengths} = this.arrays;
    lengths.forEach((length, i) => {
      const a = this.segmentOfRegion[sections[2 * i]], b = this.segmentOfRegion[sections[2 * i + 1]];
      if (a === b) return;
      for (const [here, there] of [[a, b], [b, a]]) {
        this.measures[here].border += length;
        this.measures[here].neighbors.set(there, (this.measures[here].neighbors.get(there) || 0) + length);
      }
    });
  }

  change(nodes, selected) {
    this.remember();
    this.selected = selected;
    this.hide(selected, false);
    this.setNodes(nodes);
  }

  remember() {
    this.history.push(this.nodes);
    this.future = [];
  }

  undo() { this.step(this.history, this.future); }
  redo() { this.step(this.future, this.history); }

  step(from, to) {
    if (from.length === 0) return;
    to.push(this.nodes);
    this.setNodes(from.pop());
  }

  // What is hidden.

  isConcealed(node) {
    let isConcealed = true;
    this.tree.forEachRegion(node, region => { isConcealed = isConcealed && this.isHidden[region] === 1; });
    return isConcealed;
  }

  hide(node, isHidden) { this.tree.forEachRegion(node, region => { this.isHidden[region] = isHidden ? 1 : 0; }); }

  isolate(node) {
    this.isHidden.fill(1);
    this.hide(node, false);
    this.showHidden();
    this.view.fit();
  }

  showAll() {
    this.isHidden.fill(0);
    this.showHidden();
  }

  showHidden() {
    this.list();
    this.paint();
  }

  setNumber(number) {
    const {tree} = this;
    number = Math.max(tree.least, Math.min(this.content.regions, Math.round(number) + this.otherNodes));
    if (!isFinite(number)) return this.setNodes(this.nodes);
    const isEdited = this.nodes.join() !== tree.partition(this.nodes.length).join();
    if (isEdited) {
      this.remember();
      this.toast("Your splits and joins are undone by another number. Undo brings them back.");
    }
    this.setNodes(tree.partition(number));
  }

  split(node) {
    const parts = this.tree.split(node);
    if (!parts) return this.toast(this.nameOf(node) + " is a single region and cannot be split.");
    const larger = this.tree.larger(...parts);
    this.change(this.tree.sorted(this.nodes.filter(n => n !== node).concat(parts)), larger);
  }

  join(a, b) {
    if ([a, b].includes(this.content.none)) return this.toast("Faces of no segment are not joined with one.");
    const node = this.tree.join(a, b);
    this.colors[node] = this.colors[this.tree.larger(a, b)];
    this.change(this.tree.sorted(this.nodes.filter(n => n !== a && n !== b).concat(node)), node);
    this.firstToJoin = null;
    this.paint();
  }

  // Names and colors.

  indexOf(node) { return this.nodes.indexOf(node); }

  /// As in all outputs of the program. What the user splits and joins is named by its number, and so is what has no other name
  /// beside it.
  nameOf(node) {
    if (node === this.content.none) return "No segment";
    const name = this.names.get(node), isUnchanged = this.nodes.every(n => this.names.has(n) || n === this.content.none);
    return name && (isUnchanged || !name.startsWith("segment_")) ? name : "segment_" + this.indexOf(node);
  }

  colorOf(node) {
    if (node === this.content.none) return [96, 96, 96];
    if (element("coloring").value === "kinds") return kindColors[this.kindOf(node)];
    return this.content.colors[this.colors[node] % this.content.colors.length];
  }
  cssColor(node) { return "rgb(" + this.colorOf(node).join() + ")"; }
  shareOf(node) { return this.tree.areas[node] / this.totalArea; }

  paint() {
    const glows = this.nodes.map(node => node === this.hovered ? 120 : node === this.firstToJoin ? 160 : node === this.selected ? 60 : 0);
    const colors = this.nodes.map(node => this.colorOf(node));
    this.view.show(this.segmentOfRegion, r => colors[this.segmentOfRegion[r]], r => glows[this.segmentOfRegion[r]], this.isHidden,
                   [this.selected, this.firstToJoin].map(node => this.indexOf(node)));
    for (const item of element("list").children) {
      item.classList.toggle("hovered", Number(item.dataset.node) === this.hovered);
      item.classList.toggle("selected", Number(item.dataset.node) === this.selected);
    }
  }

  // The list.

  list() {
    const longest = 200;
    const bySize = this.nodes.slice().sort((a, b) => this.tree.areas[b] - this.tree.areas[a]);
    const largest = this.tree.areas[bySize[0]] || 1;
    this.places = new Map(bySize.filter(node => node !== this.content.none).map((node, i) => [node, i + 1]));
    const items = bySize.slice(0, longest).map(node => this.item(node, largest));
    if (bySize.length > longest) {
      const more = document.createElement("li");
      more.className = "more";
      more.textContent = "and " + counted(bySize.length - longest, "smaller segment");
      items.push(more);
    }
    element("show-all").hidden = !this.isHidden.includes(1);
    this.explainColors();
    const list = element("list"), active = document.activeElement;
    const focused = list.contains(active) ? active.closest("li").dataset.node : null;
    list.replaceChildren(...items);
    if (focused !== null)
      (list.querySelector(`[data-node="${focused}"]`) || list.querySelector(".selected") || list.firstChild).focus();
  }

  /// Kinds of surface are offered where most of the area has one, and explained where they are shown.
  explainColors() {
    const isKind = node => !["not described", "other surface"].includes(this.kindOf(node));
    const area = this.nodes.reduce((sum, node) => sum + (isKind(node) ? this.tree.areas[node] : 0), 0);
    const coloring = element("coloring"), legend = element("legend");
    element("coloring-line").hidden = area < this.totalArea / 2 && coloring.value !== "kinds";
    legend.hidden = coloring.value !== "kinds";
    const kinds = new Set(this.nodes.map(node => this.kindOf(node)));
    legend.replaceChildren(...Object.keys(kindColors).filter(kind => kinds.has(kind)).map(kind => {
      const entry = document.createElement("span"), swatch = document.createElement("span");
      swatch.className = "swatch";
      swatch.style.background = "rgb(" + kindColors[kind].join() + ")";
      entry.append(swatch, kind);
      return entry;
    }));
  }

  item(node, largest) {
    const item = document.createElement("li"), shape = this.shapes.get(node);
    item.dataset.node = node;
    item.tabIndex = 0;
    const row = document.createElement("div");
    row.className = "row";
    row.innerHTML = '<span class="swatch"></span><span class="place"></span><b></b><span class="shape"></span><span class="share"></span>';
    row.children[0].style.background = this.cssColor(node);
    row.children[1].textContent = this.places.get(node) || "";
    row.children[2].textContent = this.nameOf(node);
    row.children[3].textContent = shape && this.fits(shape, node) ? shape.primitive.type : "";
    row.children[4].textContent = percent(this.shareOf(node));
    const bar = document.createElement("div");
    bar.className = "bar";
    bar.innerHTML = "<i></i>";
    bar.firstChild.style.cssText = "width:" + 100 * this.tree.areas[node] / largest + "%;background:" + this.cssColor(node);
    item.append(row, bar);
    item.classList.toggle("selected", node === this.selected);
    item.classList.toggle("concealed", this.isConcealed(node));
    if (node === this.selected) item.append(this.description(node), this.actions(node));
    return item;
  }

  /// Whether a primitive says what a segment looks like: its misfit is below a hundredth of the size.
  fits(shape, node) { return !(shape.primitive.error >= 0.01 * Math.sqrt(this.tree.areas[node])); }

  kindOf(node) {
    const shape = this.shapes.get(node);
    return !shape ? "not described" : this.fits(shape, node) ? shape.primitive.type : "other surface";
  }

  description(node) {
    const measures = this.measures[this.indexOf(node)], shape = this.shapes.get(node);
    const lines = [["Area", number(measures.area)], ["Faces", measures.faces.toLocaleString("en")]];
    if (shape) {
      lines.push(["Size", shape.extents.map(number).join(" × ")], ["Volume", number(shape.volume)]);
      const {type, radius, half_angle, error} = shape.primitive;
      const detail = radius !== undefined ? ", radius " + number(radius) : half_angle !== undefined ? ", half angle " + number(half_angle) + "°" : "";
      lines.push(["Nearest shape", type + detail], ["Misfit", number(error)]);
    }
    lines.push(["Border", number(measures.border)]);
    const neighbors = Array.from(measures.neighbors.keys()).sort((a, b) => a - b);
    lines.push(["Neighbors", neighbors.length > 0 ? neighbors.map(i => this.nameOf(this.nodes[i])).join(", ") : "none"]);
    const list = document.createElement("dl");
    for (const [term, text] of lines) {
      const dt = document.createElement("dt"), dd = document.createElement("dd");
      dt.textContent = term;
      dd.textContent = text;
      list.append(dt, dd);
    }
    return list;
  }

  actions(node) {
    const actions = document.createElement("div");
    actions.className = "actions";
    const add = (text, isPossible, act) => {
      const button = document.createElement("button");
      button.textContent = text;
      button.disabled = !isPossible;
      button.addEventListener("click", event => { event.stopPropagation(); act(); });
      actions.append(button);
    };
    add("Split", this.tree.split(node) !== null, () => this.split(node));
    add("Join …", this.nodes.length > 1, () => { this.setTool("join"); this.startJoin(node); });
    const isConcealed = this.isConcealed(node);
    add(isConcealed ? "Show" : "Hide", true, () => { this.hide(node, !isConcealed); this.showHidden(); });
    add("Isolate", this.nodes.length > 1, () => this.isolate(node));
    return actions;
  }

  // What the user does.

  setTool(tool) {
    this.tool = tool;
    this.firstToJoin = null;
    for (const button of document.querySelectorAll("[data-tool]"))
      button.setAttribute("aria-checked", String(button.dataset.tool === tool));
    element("help").textContent = this.helpOf(tool);
    this.paint();
  }

  helpOf(tool) {
    const touched = "One finger turns · two zoom and move · touch a segment to select it";
    return {
      select: matchMedia("(pointer: coarse)").matches ? touched : "Drag or arrow keys to turn · scroll or + − to zoom · right drag to move · F: the whole mesh · click a segment: H hides it, I isolates it",
      split: "Click a segment to split it in two",
      join: "Click a segment, then the one to join it with"
    }[tool];
  }

  select(node) {
    this.selected = node;
    this.list();
    this.paint();
    const item = element("list").querySelector(".selected");
    if (item) item.scrollIntoView({block: "nearest"});
  }

  startJoin(node) {
    this.firstToJoin = node;
    element("help").textContent = "Click the segment to join with " + this.nameOf(node) + " · Esc to leave it";
    this.paint();
  }

  click(node) {
    if (node === null) {
      this.firstToJoin = null;
      return this.select(null);
    }
    if (this.tool === "split") return this.split(node);
    if (this.tool === "select") return this.select(node);
    if (this.firstToJoin === null) return this.startJoin(node);
    if (this.firstToJoin !== node) {
      this.join(this.firstToJoin, node);
      this.setTool("join");
    }
  }

  hover(node) {
    if (node === this.hovered) return;
    this.hovered = node;
    this.paint();
  }

  nodeAt(event) {
    const box = element("view").getBoundingClientRect();
    const region = this.view.regionAt(event.clientX - box.left, event.clientY - box.top);
    return region >= 0 ? this.nodes[this.segmentOfRegion[region]] : null;
  }

  showTip(event, node) {
    const tip = element("tip");
    tip.hidden = node === null;
    if (node === null) return;
    tip.innerHTML = '<span class="swatch"></span><small></small><span></span><small></small>';
    tip.children[0].style.background = this.cssColor(node);
    tip.children[1].textContent = this.places.get(node) || "";
    tip.children[2].textContent = this.nameOf(node);
    const shape = this.shapes.get(node);
    tip.children[3].textContent = percent(this.shareOf(node)) + (shape && this.fits(shape, node) ? " · " + shape.primitive.type : "");
    const width = element("view").clientWidth;
    tip.style.left = Math.min(event.clientX + 16, width - tip.offsetWidth - 8) + "px";
    tip.style.top = Math.max(event.clientY - 38, 8) + "px";
  }

  toast(text) {
    element("toast").textContent = text;
    element("toast").hidden = false;
    clearTimeout(this.toastTimer);
    this.toastTimer = setTimeout(() => { element("toast").hidden = true; }, 4500);
  }

  save(blob, ending) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = element("name").textContent.replace(/\.[^.]*$/, "") + "_" + (this.nodes.length - this.otherNodes) + ending;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  labels() {
    const label = segment => this.nodes[segment] === this.content.none ? -1 : segment;
    return Array.from(this.arrays.regions, region => label(this.segmentOfRegion[region])).join("\n") + "\n";
  }

  /// A node of glTF for each segment that is shown, at its place in the picture, below one with the place of the mesh.
  saveParts() {
    const {content: {center, radius}} = this, mesh = new THREE.Group();
    mesh.position.fromArray(center);
    mesh.scale.setScalar(radius);
    const {position, normal} = this.view.geometry.attributes, corners = new Map();
    this.view.geometry.getAttribute("region").array.forEach((region, i) => {
      const segment = this.segmentOfRegion[region];
      if (this.isHidden[region]) return;
      if (!corners.has(segment)) corners.set(segment, []);
      corners.get(segment).push(i);
    });
    for (const [segment, chosen] of corners) {
      const geometry = new THREE.BufferGeometry(), node = this.nodes[segment];
      for (const [name, {array}] of Object.entries({position, normal}))
        geometry.setAttribute(name, new THREE.Float32BufferAttribute(chosen.flatMap(i => Array.from(array.subarray(3 * i, 3 * i + 3))), 3));
      const color = new THREE.Color(this.cssColor(node)).convertSRGBToLinear();
      const part = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({color, metalness: 0, roughness: 0.8, side: THREE.DoubleSide}));
      part.name = this.nameOf(node);
      if (this.view.offsets) part.position.fromArray(this.view.offsets[segment]).multiplyScalar(this.view.tables.explosion.value);
      mesh.add(part);
    }
    new THREE.GLTFExporter().parse(mesh, bytes => this.save(new Blob([bytes]), ".glb"), {binary: true});
  }

  listen() {
    this.listenToCanvas();
    element("slider").addEventListener("input", () => this.setNumber(Number(element("slider").value)));
    element("count").addEventListener("change", () => this.setNumber(parseFloat(element("count").value)));
    element("explosion").addEventListener("input", () => this.explode());
    element("coloring").addEventListener("change", () => { this.list(); this.paint(); });
    element("undo").addEventListener("click", () => this.undo());
    element("redo").addEventListener("click", () => this.redo());
    element("fit").addEventListener("click", () => this.view.fit());
    element("show-all").addEventListener("click", () => this.showAll());
    for (const button of document.querySelectorAll("[data-tool]"))
      button.addEventListener("click", () => this.setTool(button.dataset.tool));
    const list = element("list"), nodeOf = event => {
      const item = event.target.closest("li[data-node]");
      return item ? Number(item.dataset.node) : null;
    };
    list.addEventListener("pointermove", event => this.hover(nodeOf(event)));
    list.addEventListener("pointerleave", () => this.hover(null));
    const choose = event => {
      const node = nodeOf(event);
      if (node === null || event.target.closest("dl")) return;
      if (this.tool === "join" && this.firstToJoin !== null) this.click(node);
      else this.select(node === this.selected ? null : node);
    };
    list.addEventListener("click", choose);
    list.addEventListener("keydown", event => {
      if ((event.key !== "Enter" && event.key !== " ") || event.target.tagName !== "LI") return;
      choose(event);
      event.preventDefault(); // scrolling by the space bar
    });
    element("save-labels").addEventListener("click", () => this.save(new Blob([this.labels()], {type: "text/plain"}), ".seg"));
    element("save-parts").addEventListener("click", () => this.saveParts());
    element("save-picture").addEventListener("click", () => this.view.picture(blob => this.save(blob, ".png")));
    document.addEventListener("keydown", event => this.key(event));
  }

  listenToCanvas() {
    const canvas = element("view");
    let down = null, pointer = null; // where a button was pressed, and where the pointer is over the canvas
    const point = event => {
      const node = this.nodeAt(event);
      canvas.classList.toggle("pointing", node !== null);
      this.hover(node);
      this.showTip(event, node);
    };
    this.view.afterDrawing = () => { if (pointer && !down) point(pointer); };
    canvas.addEventListener("pointerdown", event => {
      canvas.focus(); // so that a number that was typed counts
      down = {x: event.clientX, y: event.clientY};
      canvas.classList.add("turning");
      element("tip").hidden = true;
    });
    window.addEventListener("pointerup", event => {
      canvas.classList.remove("turning");
      const isClick = down && event.button === 0 && Math.hypot(event.clientX - down.x, event.clientY - down.y) < 4;
      down = null;
      if (isClick && event.target === canvas) this.click(this.nodeAt(event));
    });
    canvas.addEventListener("pointermove", event => {
      pointer = event;
      if (!down) point(event);
    });
    canvas.addEventListener("pointerleave", () => {
      pointer = null;
      element("tip").hidden = true;
      this.hover(null);
    });
    canvas.addEventListener("webglcontextlost", () => fail("The browser has closed the view. Load the page again."));
  }

  key(event) {
    if (event.target.matches("input[type=number], select")) return;
    if (event.ctrlKey || event.metaKey || event.altKey) {
      const key = event.key.toLowerCase();
      if ((key !== "z" && key !== "y") || event.altKey) return;
      if (key === "y" || event.shiftKey) this.redo();
      else this.undo();
    } else {
      const isForView = event.target.matches("body, #view");
      if (!this.keyOfTool(event.key) && !this.keyOfHiding(event.key) && !(isForView && this.keyOfView(event.key))) return;
    }
    event.preventDefault();
  }

  keyOfTool(key) {
    const button = document.querySelectorAll("[data-tool]")[key - 1];
    const tool = button ? button.dataset.tool : key === "Escape" ? this.tool : undefined;
    if (tool) this.setTool(tool);
    return tool;
  }

  keyOfHiding(key) {
    if (key === "a") this.showAll();
    else if (this.selected !== null && key === "i") this.isolate(this.selected);
    else if (this.selected !== null && key === "h") {
      this.hide(this.selected, !this.isConcealed(this.selected));
      this.showHidden();
    } else return false;
    return true;
  }

  keyOfView(key) {
    const angle = 5 * Math.PI / 180, factor = 0.9;
    const turns = {ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
    const zooms = {"+": factor, "=": factor, "-": 1 / factor};
    if (turns[key]) this.view.turn(...turns[key].map(x => x * angle));
    if (zooms[key]) this.view.zoom(zooms[key]);
    if (key === "f") this.view.fit();
    return turns[key] || zooms[key] || key === "f";
  }
}
