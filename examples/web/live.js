"use strict";

// A page with the library: opens meshes, segments them by other methods and with strokes, saves them in colors.
class LivePage extends Page {
  constructor() {
    super();
    this.engine = new Engine(element("engine").textContent, (stage, fraction) => this.report(stage, fraction));
    this.strokes = new Strokes(this.view);
    document.body.classList.add("empty");
    document.title = "Segments of a mesh";
    this.addControls();
    this.listenToFiles();
    this.listenToStrokes();
  }

  addControls() {
    element("number").before(element("live-tools").content);
    document.querySelector("header").insertAdjacentHTML("beforeend", '<button id="open" title="Or drop a file">Open …</button>');
    document.querySelector("[role=radiogroup]").insertAdjacentHTML("beforeend",
      `<button data-tool="part" role="radio" title="Draw on a part that is to be a segment (4)">Part</button>
       <button data-tool="border" role="radio" title="Draw a line that is to be a border (5)">Border</button>`);
    for (const button of document.querySelectorAll("[data-tool=part], [data-tool=border]"))
      button.addEventListener("click", () => this.setTool(button.dataset.tool));
    document.querySelector("footer").insertAdjacentHTML("beforeend",
      `<button id="save-mesh" title="The mesh in the colors of its segments">Mesh</button>
       <select id="format" aria-label="Format of the mesh">
         <option>.ply</option><option>.obj</option><option>.off</option>
       </select>`);
    element("save-mesh").addEventListener("click", () => this.saveMesh());
    element("method").addEventListener("change", () => this.changeMethod());
    element("cancel").addEventListener("click", () => this.engine.cancel());
  }

  listenToFiles() {
    const input = element("file");
    for (const name of ["choose", "open"]) element(name).addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
      if (input.files.length > 0) this.open(input.files[0]);
      input.value = "";
    });
    const drop = isOver => document.body.classList.toggle("dropping", isOver);
    window.addEventListener("dragover", event => { event.preventDefault(); drop(true); });
    window.addEventListener("dragleave", event => { if (!event.relatedTarget) drop(false); });
    window.addEventListener("drop", event => {
      event.preventDefault();
      drop(false);
      if (event.dataTransfer.files.length > 0) this.open(event.dataTransfer.files[0]);
    });
  }

  // Work of the library.

  /// Shows the progress of a task, and why it failed.
  async work(task) {
    if (this.isBusy) return this.complain("Wait for what is under way, or cancel it.");
    this.isBusy = true;
    element("problem").textContent = "";
    this.report("reading", 0);
    // What takes a moment alone has no bar, which would flicker.
    const timer = setTimeout(() => { element("work").hidden = false; }, 150);
    try {
      await task();
      return true;
    } catch (error) {
      if (!(error instanceof Cancelled)) this.complain(error.message);
      return false;
    } finally {
      clearTimeout(timer);
      this.isBusy = false;
      element("work").hidden = true;
      if (this.file) this.describeSoon();
    }
  }

  complain(text) {
    const isEmpty = document.body.classList.contains("empty");
    if (isEmpty) element("problem").textContent = text;
    else this.toast(text);
  }

  /// Stages take the same part of the bar each.
  report(stage, fraction) {
    const stages = ["reading", "regions", "rays", "draws", "merging", "borders"];
    element("stage").textContent = stage;
    element("progress").value = (Math.max(0, stages.indexOf(stage)) + fraction) / stages.length;
  }

  async run(file, request) {
    const method = element("method").value;
    const {content, arrays} = await this.engine.run(file, "segment", {method, ...request});
    if (method !== this.method) element("coloring").value = method === "smooth-faces" ? "kinds" : "segments";
    this.method = method;
    const parsed = JSON.parse(content);
    return [parsed, readArrays(parsed.arrays, arrays.buffer)];
  }

  /// Two-step does not choose a number.
  numberFor(number) { return number === 0 && element("method").value === "two-step" ? (this.nodes || {length: 8}).length : number; }

  open(file) {
    return this.work(async () => {
      const none = new Uint32Array();
      const result = await this.run(file, {number: this.numberFor(0), constraints: none, seeds: none});
      document.body.classList.remove("empty"); // before the view takes its size
      this.file = file;
      this.show(...result);
      this.strokes.setMesh(this.arrays);
      this.setNodes(this.nodes);
    });
  }

  /// The same mesh by the method that is chosen and with the strokes. \param number 0: the method chooses it
  segment(number) {
    return this.work(async () => {
      const [constraints, seeds] = [this.strokes.constraints(), this.strokes.seeds()];
      this.showSegmentation(...await this.run(this.file, {number: this.numberFor(number), constraints, seeds}));
    });
  }

  async changeMethod() {
    const method = element("method"), before = this.method;
    if (!await this.segment(0)) method.value = before;
    this.setNodes(this.nodes);
  }

  async segmentWithStroke() {
    this.strokes.end();
    if (!await this.segment(this.nodes.length)) this.strokes.pop(); // it has no effect
    this.setNodes(this.nodes);
  }

  undo() {
    if (this.history.length > 0 || this.strokes.list.length === 0 || this.isBusy) return super.undo();
    this.strokes.pop();
    return this.segment(this.nodes.length);
  }

  setNodes(nodes) {
    super.setNodes(nodes);
    if (this.strokes.list.length > 0) element("undo").disabled = false;
    this.describeSoon();
  }

  describeSoon() {
    clearTimeout(this.describing);
    this.describing = setTimeout(() => this.describe(), 150); // not each that a slider passes
  }

  /// The shapes of the segments that are shown and have no description.
  async describe() {
    const {tree, file, nodes} = this, most = 200;
    const isWanted = nodes.map(node => !this.shapes.has(node)), none = 0xffffffff;
    if (this.isBusy || nodes.length > most || !isWanted.includes(true)) return;
    const wanted = this.labelsOfFaces().map(segment => isWanted[segment] ? nodes[segment] : none);
    const {shapes} = await this.engine.run(file, "describe", wanted).catch(() => ({shapes: "[]"})); // cancelled
    if (this.tree !== tree) return;
    this.addShapes(JSON.parse(shapes));
    this.list();
    this.paint();
  }

  saveMesh() {
    const ending = element("format").value, names = this.nodes.map(n => this.nameOf(n));
    return this.work(async () => {
      const {bytes} = await this.engine.run(this.file, "write", ending, this.labelsOfFaces(), names);
      this.save(new Blob([bytes]), ending);
    });
  }

  labelsOfFaces() { return this.arrays.regions.map(region => this.segmentOfRegion[region]); }

  // Strokes.

  get isDrawing() { return this.tool === "part" || this.tool === "border"; }

  helpOf(tool) {
    return {
      part: "Draw on each part that is to be a segment, with Shift on the last one again · drag beside the mesh to turn it",
      border: "Draw a line round a part · drag beside the mesh to turn it, and go on at the end",
    }[tool] || super.helpOf(tool);
  }

  setTool(tool) {
    super.setTool(tool);
    document.body.classList.toggle("drawing", this.isDrawing);
    if (this.isDrawing && this.nodes) {
      element("explosion").value = 0; // strokes are drawn on the mesh as it is
      this.explode();
    }
  }

  click(node) {
    if (!this.isDrawing) super.click(node);
  }

  listenToStrokes() {
    const canvas = element("view");
    let from = null;
    const placeOf = event => {
      const box = canvas.getBoundingClientRect();
      return {x: event.clientX - box.left, y: event.clientY - box.top};
    };
    canvas.addEventListener("pointerdown", event => {
      const at = placeOf(event);
      if (!this.isDrawing || this.isBusy || event.button !== 0 || !this.strokes.placeAt(at.x, at.y)) return;
      this.view.controls.enabled = false; // a drag beside the mesh turns it
      this.strokes.begin(this.tool, event.shiftKey);
      this.strokes.add(at, at);
      from = at;
    });
    window.addEventListener("pointermove", event => {
      if (!from) return;
      const to = placeOf(event);
      this.strokes.add(from, to);
      from = to;
    });
    window.addEventListener("pointerup", () => {
      if (!from) return;
      from = null;
      this.view.controls.enabled = true;
      this.segmentWithStroke();
    });
  }
}

window.page = new LivePage();
