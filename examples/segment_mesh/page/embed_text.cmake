# cmake -D NAME=name -D FILE=file -D SOURCE=name.cpp -P embed_text.cmake: a C++ source with the text of a file.
file(READ ${FILE} text)
file(WRITE ${SOURCE} "#include \"page/embedded_texts.h\"

namespace segment_mesh {
namespace embedded {

const char* const ${NAME} = R\"embedded(${text})embedded\";

} // namespace embedded
} // namespace segment_mesh
")
