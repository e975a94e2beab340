// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/errors.h"
#include "write/write_segmentation.h"

#ifdef SEGMENT_MESH_HAS_STEP
#include <bodies.h> // of the example mesh_to_step
#include <step_part.h>

#include <Standard_Failure.hxx>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

Step_text make_step(const Output& output, const Result& result)
try {
  const Polygon_soup& soup = result.input.soup;
  std::vector<mesh_to_step::Point> points;
  for (const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for (const Polygon_soup::Polygon polygon : soup.polygons)
    polygons.emplace_back(polygon.begin(), polygon.end());
  mesh_to_step::Step_part part = mesh_to_step::make_step_part(
    mesh_to_step::make_bodies(points, polygons));
  if (part.is_solid)
    return {std::move(part.text), std::move(part.remarks)};
  std::string reasons = "no solid of";
  for (const std::string& remark : part.remarks)
    reasons += (&remark == &part.remarks.front() ? " " : "; ") + remark;
  throw Output_error(output.file, reasons);
} catch (const Standard_Failure& failure) {
  throw Output_error(output.file, std::string("no solid: ") + failure.GetMessageString());
} catch (const std::invalid_argument& failure) {
  throw Output_error(output.file, std::string("no solid: ") + failure.what());
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
