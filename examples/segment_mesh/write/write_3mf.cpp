// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "3D Manufacturing Format, Core Specification", https://3mf.io/specification

#include "write/Segment_triangles.h"
#include "write/write_mesh.h"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace segment_mesh {

namespace {

void check(int result)
{
  if (result != 0)
    throw std::runtime_error("lib3mf fails with error " + std::to_string(result));
}

/// An object of lib3mf, which is released in the end.
class Handle
{
public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { NMR::lib3mf_release(m_object); }

  NMR::PLib3MFBase* get() const { return m_object; }
  NMR::PLib3MFBase** out() { return &m_object; }

private:
  NMR::PLib3MFBase* m_object = nullptr;
};

class Model_3mf
{
public:
  Model_3mf()
  {
    check(NMR::lib3mf_createmodel(m_model.out()));
    check(NMR::lib3mf_model_addbasematerialgroup(m_model.get(), m_materials.out()));
    check(NMR::lib3mf_basematerial_getresourceid(m_materials.get(), &m_material_group));
  }

  void add(const Segment_triangles& segment)
  {
    std::vector<NMR::MODELMESHVERTEX> vertices;
    for (const Point& p : segment.points)
      vertices.push_back({{float(p[0]), float(p[1]), float(p[2])}});
    std::vector<NMR::MODELMESHTRIANGLE> triangles;
    for (const auto& t : segment.triangles)
      triangles.push_back({{t[0], t[1], t[2]}});
    Handle object;
    check(NMR::lib3mf_model_addmeshobject(m_model.get(), object.out()));
    check(NMR::lib3mf_object_setnameutf8(object.get(), segment.name.c_str()));
    check(NMR::lib3mf_meshobject_setgeometry(object.get(), vertices.data(), DWORD(vertices.size()),
                                             triangles.data(), DWORD(triangles.size())));
    set_color(object.get(), segment);
    Handle item;
    check(NMR::lib3mf_model_addbuilditem(m_model.get(), object.get(), nullptr, item.out()));
  }

  void write(std::ostream& out)
  {
    Handle writer;
    check(NMR::lib3mf_model_querywriter(m_model.get(), "3mf", writer.out()));
    ULONG64 size = 0;
    check(NMR::lib3mf_writer_getstreamsize(writer.get(), &size));
    std::string bytes(size, '\0');
    check(
      NMR::lib3mf_writer_writetobuffer(writer.get(), reinterpret_cast<BYTE*>(bytes.data()), size));
    out.write(bytes.data(), std::streamsize(size));
  }

private:
  void set_color(NMR::PLib3MFBase* object, const Segment_triangles& segment)
  {
    const auto [red, green, blue] = segment.color;
    DWORD material = 0;
    check(NMR::lib3mf_basematerial_addmaterialutf8(m_materials.get(), segment.name.c_str(), red,
                                                   green, blue, &material));
    check(NMR::lib3mf_basematerial_setdisplaycolorrgba(m_materials.get(), material, red, green,
                                                       blue, 255)); // 0 without this: transparent
    Handle properties;
    check(NMR::lib3mf_object_createdefaultpropertyhandler(object, properties.out()));
    check(NMR::lib3mf_defaultpropertyhandler_setbasematerial(properties.get(), m_material_group,
                                                             material));
  }

  Handle m_model;
  Handle m_materials;
  DWORD m_material_group = 0;
};

} // namespace

bool can_write_3mf()
{
  return true;
}

void write_3mf(std::ostream& out, const Labelled_mesh& mesh)
{
  Model_3mf model;
  for (const Segment_triangles& segment : triangles_of_segments(mesh))
    model.add(segment);
  model.write(out);
}

} // namespace segment_mesh
