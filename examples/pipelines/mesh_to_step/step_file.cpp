// SPDX-License-Identifier: GPL-3.0-or-later

#include "step_file.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>

namespace mesh_to_step {

namespace {

/// OpenCASCADE tells on stdout what it does.
void be_silent()
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

} // namespace

bool write_step(const TopoDS_Shape& shape, const std::string& file)
{
  be_silent();
  STEPControl_Writer writer;
  return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write(file.c_str()) == IFSelect_RetDone;
}

TopoDS_Shape read_step(const std::string& file)
{
  be_silent();
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    return {};
  reader.TransferRoots();
  return reader.OneShape();
}

} // namespace mesh_to_step
