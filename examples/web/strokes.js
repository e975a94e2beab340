"use strict";

// What the user draws on the mesh: on parts, of which each is to be a segment, and lines that are to be borders.
class Strokes {
  constructor(view) {
    this.view = view;
    this.list = []; // {kind: "part" or "border", seed, places}; a place is a point of space with its face
    this.target = new THREE.WebGLRenderTarget(1, 1, {minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.Mesh(new THREE.BufferGeometry(), new THREE.ShaderMaterial({...Strokes.triangleShader, uniforms: view.tables, side: THREE.DoubleSide})));
    this.lift = {value: 0};
    this.dots = new THREE.BufferGeometry();
    view.overlay.add(this.makeDots(11, true), this.makeDots(7, false));
    view.controls.addEventListener("change", () => { this.isStale = true; });
  }

  /// Of a size in pixels; the rim is drawn first.
  makeDots(size, isRim) {
    const dots = new THREE.Points(this.dots, new THREE.ShaderMaterial({...Strokes.dotShader, transparent: true, depthWrite: false,
      uniforms: {lift: this.lift, size: {value: size * this.view.renderer.getPixelRatio()}, rim: {value: isRim ? 1 : 0}}}));
    dots.renderOrder = isRim ? 0 : 1;
    dots.frustumCulled = false;
    return dots;
  }

  /// Forgets all. \param mesh points, sizes, corners: arrays
  setMesh(mesh) {
    this.mesh = mesh;
    this.list = [];
    this.pointsAround = null;
    const {geometry} = this.view, numbers = new Float32Array(3 * this.view.facesOfTriangles.length);
    for (let c = 0; c < numbers.length; ++c) numbers[c] = c / 3 | 0;
    geometry.setAttribute("triangle", new THREE.BufferAttribute(numbers, 1));
    this.scene.children[0].geometry = geometry;
    this.starts = new Uint32Array(mesh.sizes.length + 1);
    mesh.sizes.forEach((size, face) => { this.starts[face + 1] = this.starts[face] + size; });
    this.isStale = true;
    this.show();
  }

  /// The place that is seen at a point of the canvas, or null.
  placeAt(x, y) {
    const {renderer, camera, geometry} = this.view, ratio = renderer.getPixelRatio(), pixel = new Uint8Array(4);
    const size = renderer.getDrawingBufferSize(new THREE.Vector2());
    if (this.isStale || this.isHidden !== this.view.isHidden || size.x !== this.target.width || size.y !== this.target.height) {
      this.target.setSize(size.x, size.y);
      camera.updateMatrixWorld();
      renderer.setRenderTarget(this.target);
      renderer.clear();
      renderer.render(this.scene, camera);
      renderer.setRenderTarget(null);
      this.isStale = false;
      this.isHidden = this.view.isHidden;
    }
    renderer.readRenderTargetPixels(this.target, Math.floor(x * ratio), size.y - 1 - Math.floor(y * ratio), 1, 1, pixel);
    const triangle = pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
    if (triangle < 0) return null;
    const positions = geometry.getAttribute("position");
    const corners = [0, 1, 2].map(i => new THREE.Vector3().fromBufferAttribute(positions, 3 * triangle + i));
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(2 * ratio * x / size.x - 1, 1 - 2 * ratio * y / size.y), camera);
    const plane = new THREE.Plane().setFromCoplanarPoints(...corners), point = ray.ray.intersectPlane(plane, new THREE.Vector3());
    return {face: this.view.facesOfTriangles[triangle], point: point || corners[0]};
  }

  /// \param goesOn whether a part is that of the stroke before
  begin(kind, goesOn) {
    const seeds = this.list.filter(stroke => stroke.kind === "part").map(stroke => stroke.seed);
    const last = Math.max(-1, ...seeds);
    this.list.push({kind, seed: goesOn && last >= 0 ? last : last + 1, places: []});
  }

  /// Adds what is seen from the last point of the canvas to this one.
  add(from, to) {
    const stroke = this.list[this.list.length - 1], steps = Math.max(1, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / 3));
    for (let i = 1; i <= steps; ++i) {
      const place = this.placeAt(from.x + (to.x - from.x) * i / steps, from.y + (to.y - from.y) * i / steps);
      if (place) stroke.places.push(place);
    }
    this.show();
  }

  /// Closes a line whose ends are near to each other, or to an end of another line, as they are seen.
  end() {
    const line = this.list[this.list.length - 1];
    if (line.kind !== "border" || line.places.length < 2) return;
    const ends = this.list.filter(other => other.kind === "border" && other !== line)
      .flatMap(other => [other.places[0], other.places[other.places.length - 1]]);
    const first = line.places[0], last = line.places[line.places.length - 1];
    const atFirst = this.nearest(first, ends), atLast = this.nearest(last, line.places.length > 8 ? [...ends, first] : ends);
    if (atFirst) line.places.unshift(atFirst);
    if (atLast) line.places.push(atLast);
  }

  nearest(place, others) {
    const reach = 16, {clientWidth, clientHeight} = this.view.canvas; // in pixels
    const seen = other => {
      const p = other.point.clone().project(this.view.camera);
      return [p.x * clientWidth / 2, p.y * clientHeight / 2];
    };
    const [x, y] = seen(place), depth = 0.1 * this.view.radius;
    let least = reach, found = null;
    for (const other of others) {
      const [u, v] = seen(other), distance = Math.hypot(u - x, v - y);
      if (distance < least && other.point.distanceTo(place.point) < depth) [least, found] = [distance, other];
    }
    return found;
  }

  pop() {
    this.list.pop();
    this.show();
  }

  /// Faces and their seeds, two by two; a face that two strokes meet has the later one's.
  seeds() {
    const seedOfFace = new Map();
    for (const {kind, seed, places} of this.list)
      if (kind === "part") for (const {face} of places) seedOfFace.set(face, seed);
    return Uint32Array.from(Array.from(seedOfFace).flat());
  }

  /// The points of edges, two by two: the way over the fewest edges through the points next to the lines.
  constraints() {
    const ends = [];
    for (const {kind, places} of this.list) {
      if (kind !== "border") continue;
      const points = places.map(place => this.pointNextTo(place));
      for (let i = 1; i < points.length; ++i)
        if (points[i] !== points[i - 1]) {
          const way = this.shortestWay(points[i - 1], points[i]);
          for (let j = 1; j < way.length; ++j) ends.push(way[j - 1], way[j]);
        }
    }
    return Uint32Array.from(ends);
  }

  pointNextTo({face, point}) {
    const polygon = this.mesh.corners.subarray(this.starts[face], this.starts[face + 1]);
    const distance = i => point.distanceTo(new THREE.Vector3().fromArray(this.mesh.points, 3 * i));
    return polygon.reduce((best, i) => distance(i) < distance(best) ? i : best);
  }

  /// The points that edges join with each point.
  get neighbors() {
    if (this.pointsAround) return this.pointsAround;
    const {points, sizes, corners} = this.mesh;
    this.pointsAround = Array.from({length: points.length / 3}, () => []);
    sizes.forEach((size, face) => {
      for (let i = 0; i < size; ++i) {
        const a = corners[this.starts[face] + i], b = corners[this.starts[face] + (i + 1) % size];
        this.pointsAround[a].push(b);
        this.pointsAround[b].push(a);
      }
    });
    return this.pointsAround;
  }

  /// The points of the way over the fewest edges, from one to the other; none if there is no way.
  shortestWay(from, to) {
    const previous = new Map([[from, from]]);
    for (let front = [from]; front.length > 0 && !previous.has(to);) {
      const next = [];
      for (const p of front)
        for (const q of this.neighbors[p])
          if (!previous.has(q)) {
            previous.set(q, p);
            next.push(q);
          }
      front = next;
    }
    const way = previous.has(to) ? [to] : [];
    while (way.length > 0 && way[0] !== from) way.unshift(previous.get(way[0]));
    return way;
  }

  show() {
    const positions = [], darkness = [];
    for (const {kind, places} of this.list)
      for (const {point} of places) {
        positions.push(point.x, point.y, point.z);
        darkness.push(kind === "border" ? 1 : 0);
      }
    this.dots.dispose();
    this.dots.setAttribute("position", new THREE.BufferAttribute(new Float32Array(positions), 3));
    this.dots.setAttribute("darkness", new THREE.BufferAttribute(new Float32Array(darkness), 1));
    this.lift.value = 0.01 * this.view.radius;
    this.view.overlay.visible = positions.length > 0;
    this.view.isStale = true;
  }
}

/// The number of the triangle and 1 in three bytes; 0 is the background.
Strokes.triangleShader = {
  vertexShader: MeshView.regionShader.vertexShader.replace("float region", "float region, triangle").replace("number = region", "number = triangle"),
  fragmentShader: MeshView.regionShader.fragmentShader
};

/// Discs, a little above the surface.
Strokes.dotShader = {
  vertexShader: `
    attribute float darkness;
    uniform float size, lift;
    varying float dark;
    void main()
    {
      dark = darkness;
      vec4 seen = modelViewMatrix * vec4(position, 1.0);
      seen.xyz *= 1.0 - lift / length(seen.xyz);
      gl_Position = projectionMatrix * seen;
      gl_PointSize = size;
    }`,
  fragmentShader: `
    uniform float rim;
    varying float dark;
    void main()
    {
      float radius = length(2.0 * gl_PointCoord - 1.0);
      gl_FragColor = vec4(vec3(rim > 0.5 ? dark : 1.0 - dark), 1.0 - smoothstep(0.75, 1.0, radius));
    }`
};
