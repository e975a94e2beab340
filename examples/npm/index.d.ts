/** An array of rows, or of their numbers one after another. */
export type Rows = ArrayLike<number> | ReadonlyArray<ArrayLike<number>>;

export interface Options {
  /** Left out, the method chooses it; `two-step` needs it. */
  numberOfSegments?: number;
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

/**
 * The segment of each face, 0 to n - 1 in the order of their first faces.
 * @param points three coordinates each
 * @param faces the indices of the corners of each face, or of triangles one after another; the mesh
 *   need not be manifold, oriented or connected
 * @throws an error that names the place, where the mesh cannot be segmented
 */
export function segment(points: Rows, faces: Rows, options?: Options): Promise<Uint32Array>;
