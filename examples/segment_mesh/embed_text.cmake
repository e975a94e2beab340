# cmake -D NAME=name -D FILE=file -D SOURCE=name.cpp -P embed_text.cmake: a C++ source with the text of a file.
file(READ ${FILE} text)
file(WRITE ${SOURCE} "namespace segment_mesh {
namespace embedded {

extern const char* const ${NAME};
const char* const ${NAME} = R\"embedded(${text})embedded\";

} // namespace embedded
} // namespace segment_mesh
")
