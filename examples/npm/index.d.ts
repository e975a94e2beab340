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
