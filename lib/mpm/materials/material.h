// What every material of the engine has in common.
#pragma once

namespace tidewater::mpm {

// What a pass over particles finds for the time step and the checks.
struct Findings {
    double min_j = 0.0;     // ≤ 0, min. J − 1 of water
    bool unusable = false;  // the state of some particle cannot be used

    void add(const Findings& other) {
        min_j = other.min_j < min_j ? other.min_j : min_j;
        unusable = unusable || other.unusable;
    }
};

}  // namespace tidewater::mpm
