// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine part as a solid of planes, cylinders, cones, spheres, tori and freeform faces, in a
// STEP file: mesh_to_step PART.stl PART.step. Ends with 1 if the solid in the file is not closed,
// valid, and of the volume of the part.

#include "../../example_mesh.h"

#include "step_text.h"

#include <Standard_Failure.hxx>

int main(int argc, char** argv)
try {
  const mesh_to_step::Step_part part = mesh_to_step::make_step_part(
    read_mesh(argc, argv, "flange.off"));
  for (const std::string& remark : part.remarks)
    std::cout << remark << '\n';
  const char* const name = argc > 2 ? argv[2] : "mesh_to_step.step";
  std::ofstream file(name, std::ios::binary);
  file << part.text;
  file.close();
  if (!file)
    std::cerr << name << " cannot be written\n";
  return part.is_solid && file ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const Standard_Failure& failure) {
  std::cerr << "no solid is made: " << failure.GetMessageString() << '\n';
  return EXIT_FAILURE;
}
