// Walls of the box that a scene lives in.
//
//     slip      the velocity into or out of the wall is zero, along it free
//     stick     the velocity is zero
//     separate  as slip, but what moves away from the wall may leave it
//
// A rule acts on the grid nodes on the wall's plane and beyond it. Source: shared/physics.md §5.
#pragma once

namespace tidewater::mpm {

enum class WallRule { slip, stick, separate };

}  // namespace tidewater::mpm
