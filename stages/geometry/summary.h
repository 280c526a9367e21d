// What the geometry stage made, in words: volumes, masses, the ice's front, what is cut into it, and what a
// simulation of it will need.
#pragma once

#include <string>

#include "bodies.h"

namespace tidewater {

std::string summary(const scene::Scene& scene, const Bodies& bodies);

}  // namespace tidewater
