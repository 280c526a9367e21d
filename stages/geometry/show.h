// What the geometry stage writes to be looked at: surfaces and an image for ParaView, and a picture.
#pragma once

#include <openvdb/openvdb.h>

#include <vector>

#include "bodies.h"
#include "common/stage.h"

namespace tidewater {

void show(const StageContext& context, const Bodies& bodies,
          const std::vector<openvdb::FloatGrid::Ptr>& grids);

}  // namespace tidewater
