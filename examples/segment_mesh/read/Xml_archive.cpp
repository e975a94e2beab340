// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Xml_archive.h"

#include "read/errors.h"
#include "read/load_bytes.h"

#include <expat.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <cstdio>
#include <exception>

namespace segment_mesh {

namespace {

/// An XML parser that calls a function, and keeps what the function throws: exceptions do not pass
/// through the functions of expat.
class Xml_parser
{
public:
  explicit Xml_parser(const std::function<void(const Xml_element&)>& take)
    : m_take(take)
    , m_parser(XML_ParserCreateNS(nullptr, ' '), XML_ParserFree)
  {
    XML_SetUserData(m_parser.get(), this);
    XML_SetElementHandler(
      m_parser.get(),
      [](void* self, const char* name, const char** attributes) {
        static_cast<Xml_parser*>(self)->call({name, attributes});
      },
      [](void* self, const char* name) {
        static_cast<Xml_parser*>(self)->call({name, nullptr});
      });
    XML_SetStartDoctypeDeclHandler(m_parser.get(), [](void* self, auto...) {
      static_cast<Xml_parser*>(self)->stop(
        std::make_exception_ptr(Value_error("a document type, which the format does not allow")));
    });
  }

  void parse(const char* bytes, std::size_t size, bool is_last)
  {
    const XML_Status status = XML_Parse(m_parser.get(), bytes, int(size), is_last);
    if (m_failure)
      std::rethrow_exception(m_failure);
    if (status == XML_STATUS_ERROR)
      throw Value_error(std::string("is not XML: ") +
                        XML_ErrorString(XML_GetErrorCode(m_parser.get())));
  }

  std::size_t line() const { return XML_GetCurrentLineNumber(m_parser.get()); }

private:
  void call(const Xml_element& element)
  {
    try {
      if (!m_failure)
        m_take(element);
    } catch (...) {
      stop(std::current_exception());
    }
  }

  void stop(std::exception_ptr failure)
  {
    m_failure = failure;
    XML_StopParser(m_parser.get(), XML_FALSE);
  }

  const std::function<void(const Xml_element&)>& m_take;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> m_parser;
  std::exception_ptr m_failure;
};

/// The bytes of an archive, as a stream.
struct Archive_bytes
{
  const char* data;
  std::size_t size;
};

voidpf open_bytes(voidpf bytes, const void*, int)
{
  const auto& [data, size] = *static_cast<const Archive_bytes*>(bytes);
  return fmemopen(const_cast<char*>(data), size, "rb"); // which is not written
}

} // namespace

std::optional<std::string_view> Xml_element::find(std::string_view name) const
{
  for (const char* const* i = m_attributes; *i; i += 2)
    if (without_namespace(*i) == name)
      return *(i + 1);
  return std::nullopt;
}

std::string_view Xml_element::at(std::string_view name) const
{
  if (const auto value = find(name))
    return *value;
  throw Value_error("<" + std::string(this->name()) + "> without '" + std::string(name) + "'");
}

void Xml_archive::Close::operator()(void* archive) const
{
  unzClose(archive);
}

Xml_archive::Xml_archive(const std::string& file, std::string_view bytes)
  : m_file(file)
  , m_most_bytes((std::max)(harmless_size, largest_inflation * bytes.size()))
{
  Archive_bytes stream{bytes.data(), bytes.size()};
  zlib_filefunc64_def functions;
  fill_fopen64_filefunc(&functions);
  functions.zopen64_file = open_bytes;
  functions.opaque = &stream;
  m_zip.reset(bytes.empty() ? nullptr : unzOpen2_64("", &functions));
  if (!m_zip)
    throw Input_error(file, "is not a ZIP archive, as .3mf is");
}

bool Xml_archive::has(const std::string& entry) const
{
  constexpr int in_any_case = 2;
  return unzLocateFile(m_zip.get(), entry.c_str(), in_any_case) == UNZ_OK;
}

std::string Xml_archive::inflated(const std::string& entry)
{
  const std::string place = m_file + ": " + entry;
  if (!has(entry))
    throw Input_error(place, "is not in the archive");
  if (unzOpenCurrentFile(m_zip.get()) != UNZ_OK)
    throw Input_error(place, "cannot be read: it is damaged, encrypted, or compressed otherwise "
                             "than by Deflate");
  constexpr std::size_t step = std::size_t(1) << 20;
  std::string text;
  for (int size = 1; size > 0;) {
    const std::size_t before = text.size();
    text.resize(before + step);
    size = unzReadCurrentFile(m_zip.get(), &text[before], unsigned(step));
    if (size < 0)
      throw Input_error(place, "is damaged");
    text.resize(before + std::size_t(size));
    if ((m_number_of_bytes += std::size_t(size)) > m_most_bytes)
      throw Input_error(m_file, "is a ZIP archive that grows by more than " +
                                  std::to_string(largest_inflation) + " times");
  }
  if (unzCloseCurrentFile(m_zip.get()) != UNZ_OK) // the checksum
    throw Input_error(place, "is damaged");
  return text;
}

void Xml_archive::read(const std::string& entry,
                       const std::function<void(const Xml_element&)>& take)
{
  const std::string text = inflated(entry);
  constexpr std::size_t step = std::size_t(1) << 16; // expat takes the size as an int
  Xml_parser parser(take);
  try {
    for (std::size_t i = 0; i < text.size(); i += step)
      parser.parse(&text[i], (std::min)(step, text.size() - i), false);
    parser.parse("", 0, true);
  } catch (const Value_error& error) {
    throw Input_error(m_file + ": " + entry, parser.line(), error.what());
  }
}

} // namespace segment_mesh
