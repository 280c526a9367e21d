#include "io/vtk_messages.h"

#include <vtkObjectFactory.h>

namespace tidewater::io {

vtkStandardNewMacro(VtkMessages);

}  // namespace tidewater::io
