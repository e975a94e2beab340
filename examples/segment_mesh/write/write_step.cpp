// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/errors.h"
#include "write/write_segmentation.h"

#ifdef SEGMENT_MESH_HAS_STEP
#include "segmentation/Manifold.h"

#include <step_part.h> // of the example mesh_to_step

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <Standard_Failure.hxx>

#include <string>
#include <utility>

namespace segment_mesh {

Step_text make_step(const Output& output, const Result& result)
try {
  mesh_to_step::Mesh mesh;
  CGAL::copy_face_graph(make_manifold(result.input.soup).mesh, mesh);
  if (!CGAL::Polygon_mesh_processing::triangulate_faces(mesh))
    throw Output_error(output.file, "no solid: a face has a hole, or crosses itself");
  mesh_to_step::Step_part part = mesh_to_step::make_step_part(mesh);
  if (part.is_solid)
    return {std::move(part.text), std::move(part.remarks)};
  std::string reasons = "no solid of";
  for (const std::string& remark : part.remarks)
    reasons += (&remark == &part.remarks.front() ? " " : "; ") + remark;
  throw Output_error(output.file, reasons);
} catch (const Standard_Failure& failure) {
  throw Output_error(output.file, std::string("no solid: ") + failure.GetMessageString());
}

} // namespace segment_mesh
#else
namespace segment_mesh {

Step_text make_step(const Output& output, const Result&)
{
  throw Output_error(output.file,
                     "solids need OpenCASCADE (Debian: libocct-data-exchange-dev), and "
                     "this program was built without it");
}

} // namespace segment_mesh
#endif
