// SPDX-License-Identifier: GPL-3.0-or-later

// A .3mf file, read by lib3mf.

#include "write/write_mesh.h"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <gtest/gtest.h>

#include <sstream>

namespace write_3mf_test {

using namespace segment_mesh;
using Object = NMR::PLib3MFBase*;

/// Two triangles and a square in segments 0 and 2; segment 1 is a face without area. Of the points
/// the fourth is not of the triangles, the last one not of the square.
TEST(Write_3mf, has_an_object_for_each_segment)
{
  Polygon_soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1e-7, 1.0 / 3, 3e7}};
  soup.polygons = {{0, 1, 4}, {0, 1, 2, 3}, {0, 0, 1}, {1, 2, 4}};
  std::ostringstream out;
  write_3mf(out, {soup, {0, 2, 1, 0}});
  const std::string bytes = out.str();

  Object model, reader, items;
  ASSERT_EQ(NMR::lib3mf_createmodel(&model), 0);
  ASSERT_EQ(NMR::lib3mf_model_queryreader(model, "3mf", &reader), 0);
  ASSERT_EQ(NMR::lib3mf_reader_readfrombuffer(
              reader, reinterpret_cast<BYTE*>(const_cast<char*>(bytes.data())), bytes.size()),
            0);
  DWORD warnings = 1;
  ASSERT_EQ(NMR::lib3mf_reader_getwarningcount(reader, &warnings), 0);
  EXPECT_EQ(warnings, 0u);
  ASSERT_EQ(NMR::lib3mf_model_getbuilditems(model, &items), 0);

  for (std::size_t segment : {0, 2}) {
    BOOL has_next = false;
    ASSERT_EQ(NMR::lib3mf_builditemiterator_movenext(items, &has_next), 0);
    ASSERT_TRUE(has_next);
    Object item, object, properties, materials;
    ASSERT_EQ(NMR::lib3mf_builditemiterator_getcurrent(items, &item), 0);
    ASSERT_EQ(NMR::lib3mf_builditem_getobjectresource(item, &object), 0);
    char name[64];
    ULONG size;
    ASSERT_EQ(NMR::lib3mf_object_getnameutf8(object, name, sizeof name, &size), 0);
    EXPECT_EQ(std::string(name), "segment_" + std::to_string(segment));
    DWORD points, triangles, group, material;
    ASSERT_EQ(NMR::lib3mf_meshobject_getvertexcount(object, &points), 0);
    ASSERT_EQ(NMR::lib3mf_meshobject_gettrianglecount(object, &triangles), 0);
    EXPECT_EQ(points, 4u);
    EXPECT_EQ(triangles, 2u);

    ASSERT_EQ(NMR::lib3mf_object_createdefaultpropertyhandler(object, &properties), 0);
    ASSERT_EQ(NMR::lib3mf_defaultpropertyhandler_getbasematerial(properties, &group, &material), 0);
    ASSERT_EQ(NMR::lib3mf_model_getbasematerialbyid(model, group, &materials), 0);
    std::array<BYTE, 4> color; // lib3mf 1 gives 0 for the last one, which the file does not have
    ASSERT_EQ(NMR::lib3mf_basematerial_getdisplaycolor(materials, material, &color[0], &color[1],
                                                       &color[2], &color[3]),
              0);
    const Color expected = segment_color(segment);
    EXPECT_EQ(color, (std::array<BYTE, 4>{expected[0], expected[1], expected[2], color[3]}));

    for (DWORD p = 0; p < points; ++p) {
      NMR::MODELMESHVERTEX vertex;
      ASSERT_EQ(NMR::lib3mf_meshobject_getvertex(object, p, &vertex), 0);
      const Point& expected_point = soup.points[segment == 0 && p == 3 ? 4 : p];
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_EQ(vertex.m_fPosition[j], float(expected_point[j]));
    }
  }
  BOOL has_next = true;
  ASSERT_EQ(NMR::lib3mf_builditemiterator_movenext(items, &has_next), 0);
  EXPECT_FALSE(has_next);
  NMR::lib3mf_release(model);
}

} // namespace write_3mf_test
