// SPDX-License-Identifier: GPL-3.0-or-later

#include "step_text.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <sstream>

namespace mesh_to_step {

namespace {

/// OpenCASCADE tells on stdout what it does.
void be_silent()
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

/// Names what a part of a shape is in the file.
void name(const STEPControl_Writer& writer, const TopoDS_Shape& part, const std::string& text)
{
  const Handle(StepRepr_RepresentationItem)
    item = STEPConstruct::FindEntity(writer.WS()->TransferWriter()->FinderProcess(), part);
  if (!item.IsNull())
    item->SetName(new TCollection_HAsciiString(text.c_str()));
}

} // namespace

std::string body_name(std::size_t body)
{
  return "body_" + std::to_string(body + 1);
}

std::string step_text(const TopoDS_Shape& shape, const std::vector<std::string>& face_names)
{
  be_silent();
  STEPControl_Writer writer;
  std::ostringstream text;
  if (writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone) {
    std::size_t number = 0;
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
      name(writer, solid.Current(), body_name(number++));
    TopExp_Explorer face(shape, TopAbs_FACE);
    for (auto next = face_names.begin(); face.More() && next != face_names.end(); face.Next())
      name(writer, face.Current(), *next++);
    StepData_StepWriter lines(writer.Model());
    lines.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
    lines.Print(text);
  }
  return text.str();
}

Named_shape shape_of(const std::string& step_text)
{
  be_silent();
  STEPControl_Reader reader;
  std::istringstream text(step_text);
  Named_shape result;
  if (reader.ReadStream("part", text) != IFSelect_RetDone)
    return result;
  reader.TransferRoots();
  result.shape = reader.OneShape();
  for (TopExp_Explorer face(result.shape, TopAbs_FACE); face.More(); face.Next()) {
    // The reader knows the faces of a body without the place of the body in an assembly.
    const TopoDS_Shape in_its_body = face.Current().Located(TopLoc_Location());
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(
      reader.WS()->TransferReader()->EntityFromShapeResult(in_its_body, 1));
    result.face_names.push_back(item.IsNull() ? "" : item->Name()->ToCString());
  }
  return result;
}

} // namespace mesh_to_step
