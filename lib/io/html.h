// Pieces that the project's HTML pages share.
#pragma once

#include <string>

#include "core/provenance.h"

namespace tidewater::io {

// The provenance as an HTML comment, which nothing in it can end.
std::string provenance_comment(const Provenance& provenance);

}  // namespace tidewater::io
