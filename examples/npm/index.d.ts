/** An array of rows, or of their numbers one after another. */
export type Rows = ArrayLike<number> | ReadonlyArray<ArrayLike<number>>;

export interface SegmenterOptions {
  /** `learned` by default. */
  method?: "learned" | "visibility" | "two-step" | "smooth-faces";
  /** Pairs of indices of points: edges that always are borders. */
  constrainedEdges?: Rows;
  /**
   * An integer for each face, -1 for none: equal seeds end in one segment, different ones in
   * different segments.
   */
  seeds?: ArrayLike<number>;
  /** Whether components that touch or are near each other are adjacent; true by default. */
  componentLinks?: boolean;
}

export interface Options extends SegmenterOptions {
  /** Left out, the method chooses it; `two-step` needs it. */
  numberOfSegments?: number;
}

/**
 * The segment of each face, 0 to n - 1 in the order of their first faces.
 * @param points three coordinates each
 * @param faces the indices of the corners of each face, or of triangles one after another; the mesh
 *   need not be manifold, oriented or connected
 * @throws an error that names the place, where the mesh cannot be segmented
 */
export function segment(points: Rows, faces: Rows, options?: Options): Promise<Uint32Array>;

/** A mesh that is prepared once, and segmented into any number of segments in little time. */
export class Segmenter {
  private constructor();
  /** Arguments and errors are those of `segment()`. */
  static create(points: Rows, faces: Rows, options?: SegmenterOptions): Promise<Segmenter>;
  /** The segment of each face; the method chooses the number that is left out. */
  segment(numberOfSegments?: number): Uint32Array;
  /** Releases the memory, which is not collected; the segmenter cannot be used afterwards. */
  free(): void;
}

/** What a surface does not have is left out. */
export interface Surface {
  type: "plane" | "cylinder" | "cone" | "sphere" | "torus" | "freeform";
  /** The largest distance of a vertex. */
  deviation?: number;
  /** A point of the plane or of the axis of the cylinder; an apex, a center. */
  point?: [number, number, number];
  /** A normal or an axis. */
  direction?: [number, number, number];
  /** From `point` along `direction`. */
  extent?: [number, number];
  /** The major one of a torus. */
  radius?: number;
  minorRadius?: number;
  /** Of a cone, in degrees. */
  halfAngle?: number;
}

export interface PartFace {
  surface: Surface;
  isConcave: boolean;
  /** Fillets and rounds are blends. */
  role?: "blend" | "hole" | "boss";
  area: number;
  /** The first face on the same surface, and the first one with the same axis. */
  firstOnSurface: number;
  firstOnAxis: number;
  neighbors: {face: number, length: number, isSmooth: boolean}[];
}

/**
 * The faces of a machine part as its designer drew them, and which of them each face of the mesh is of.
 * @param options `tolerance`: how far vertices may be from their surfaces; found from the mesh by default
 */
export function findPartFaces(points: Rows, faces: Rows, options?: {tolerance?: number}):
  Promise<{labels: Int32Array, faces: PartFace[]}>;
