// What every material of the engine has in common.
#pragma once

namespace tidewater::mpm {

// What a pass over particles found out about them, for the time step and the checks.
struct Findings {
    double min_j = 0.0;     // J − 1 of the most compressed water, at most 0
    bool unusable = false;  // a particle has a state that cannot be used

    void add(const Findings& other) {
        min_j = other.min_j < min_j ? other.min_j : min_j;
        unusable = unusable || other.unusable;
    }
};

}  // namespace tidewater::mpm
