// SPDX-License-Identifier: GPL-3.0-or-later

// write_seeds DIR: a folder of first inputs for each fuzz target.

#include "sample_files.h"

#include <filesystem>
#include <fstream>

using sample::with;

namespace {

class Corpus
{
public:
  Corpus(const std::filesystem::path& root, const std::string& target)
    : m_folder(root / target)
  {
    std::filesystem::create_directories(m_folder);
  }

  void add(const std::string& bytes)
  {
    std::ofstream(m_folder / std::to_string(m_size++), std::ios::binary) << bytes;
  }

private:
  std::filesystem::path m_folder;
  int m_size = 0;
};

void write_off(Corpus corpus)
{
  corpus.add(sample::off());
  corpus.add(with(sample::off(), "OFF\n4 4 0", "OFF4 4 0"));
  corpus.add("OFF\n3 1 0 # x\n0 0 0\n2 0 0\n0 1e-3 +0.5E1\n3 0 1 2 255 0 0\n");
  corpus.add("COFF 3 1 0 0 0\r0 1 0 0 1\n1 0 0 1 0 0 1 0 1 0 0 1 3 0\n1 2");
  corpus.add("CNOFF\n3 1 0\n0 0 0 0 0 1 255 0 9 255\n1 0 0 0 0 1 .5 1 0\n0 1 0\n3 0 1 2\n");
  corpus.add("STCNOFF\r\n3 1 0\r\n0 0 0 0 0 1\r\n1 0 0 0 0 1\r\n0 1 0 0 0 1\r\n3 0 1 2\r\n");
}

void write_obj(Corpus corpus)
{
  corpus.add(sample::obj());
  corpus.add("\xef\xbb\xbf# x\nmtllib a\no b\nv 0 0 0 1 0 0\nvt 0 0\nvn 0 0 1\nv 1 0 \\\n0\nv 0 1 "
             "0\nf -3/1/1 2//1 3/1\nhello\nusemtl x y\nf 1/-1 2/2 3/\ng\nf 1 2 3\n");
}

void write_ply(Corpus corpus)
{
  corpus.add(sample::ply());
  for (const char* format : {"binary_little_endian", "binary_big_endian"}) {
    corpus.add(sample::binary_ply(format));
    corpus.add(with(sample::binary_ply(format), "element vertex",
                    "element empty 0\nproperty list int double a\nelement vertex"));
  }
  for (const char* type : {"char", "ushort", "int", "uint32", "float64"})
    corpus.add(with(sample::ply(), "float x", std::string(type) + " x"));
  corpus.add("ply\nformat ascii 1.0\ncomment x\nobj_info y\nelement vertex 3\nproperty uchar "
             "r\nproperty double x\n"
             "property double y\nproperty double z\nelement face 1\nproperty list uchar float uv\n"
             "property list short ushort vertex_index\nend_header\n1 0 0 0\n1 1 0 0\n1 0 1 0\n2 "
             "0.5 0.5 3 0 1 2\n");
  corpus.add("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nproperty uchar red\nproperty ushort green\nproperty float blue\n"
             "property float s\nproperty double t\nelement face 1\n"
             "property list uchar float texcoord\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0 9 9 .5 0 1\n1 0 0 1 2 3 4 5\n0 1 0 0 0 0 nan 1\n"
             "6 0 1 1 0 .5 x 3 0 1 2\n");
}

void write_stl(Corpus corpus)
{
  corpus.add(sample::stl());
  corpus.add(sample::binary_stl());
  corpus.add(sample::binary_stl("solid"));
}

void write_gltf(Corpus corpus)
{
  corpus.add(sample::gltf());
  corpus.add(sample::glb());
  corpus.add(sample::glb(with(sample::gltf_json(""), R"({"mesh":0})",
                              R"({"mesh":0,"rotation":[0,0,1,1],"scale":[1,2,-3]})")));
  const std::string textured = with(
    with(sample::gltf_json(""), R"("POSITION":0)", R"("POSITION":0,"COLOR_0":0,"TEXCOORD_0":2)"),
    R"("accessors":[)",
    R"("materials":[{"name":"x"}],"images":[{"bufferView":1},{"uri":"a.png"}],"accessors":[)");
  corpus.add(sample::glb(
    with(with(textured, R"("mode":4)", R"("mode":4,"material":0)"), R"("type":"SCALAR"})",
         R"("type":"SCALAR"},{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})")));
  corpus.add(
    sample::glb(with(sample::gltf_json(""), R"("indices":1,"mode":4)", R"("indices":1,"mode":5)")));
}

/// ZIP archives of one file that is not compressed, whose text thus is changed by fuzzing, too.
void write_three_mf(Corpus corpus)
{
  const std::string start =
    R"(<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)"
    R"(<basematerials id="5"><base name="a"/><base name="b"/></basematerials><object id="1" pid="5" pindex="1"><mesh>)"
    R"(<vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices><triangles>)";
  const std::string end =
    R"(</triangles></mesh></object><object id="2"><components><component objectid="1"/></components>)"
    R"(</object></resources><build><item objectid="2"/></build></model>)";
  for (const char* more : {"", R"(paint_color="88443")", R"(p1="0")"})
    corpus.add(sample::zip("3D/3dmodel.model",
                           start + R"(<triangle v1="0" v2="1" v3="2" )" + more + "/>" + end));
}

void write_labels(Corpus corpus)
{
  corpus.add("0\n1\n1\n0\n");
  corpus.add(" -7 \r\n9223372036854775807\n\n\n");
}

void write_command_lines(Corpus corpus)
{
  corpus.add("a.off");
  corpus.add("a.off\nb.ply.gz\n-k\n7\n-o\nparts/{stem}.obj\n--quiet\n--threads\n2");
  corpus.add("-\n--input-format\nstl\n-k\n3\n--method\ntwo-step\n--features\nall\n--max-angle\n20."
             "5\n-o\n{stem}.json");
  corpus.add("a.obj\n--truth\n{stem}.seg\n--truth\nb.seg\n--method="
             "visibility\n-o=x.png\n-o\nx.seg\n-o\nx.off");
  corpus.add("--help");
  corpus.add("--version");
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
    return 2;
  const std::filesystem::path root = argv[1];
  write_off({root, "read_off"});
  write_obj({root, "read_obj"});
  write_ply({root, "read_ply"});
  write_stl({root, "read_stl"});
  write_gltf({root, "read_gltf"});
  write_three_mf({root, "read_three_mf"});
  write_labels({root, "read_labels"});
  write_command_lines({root, "command_line"});
}
