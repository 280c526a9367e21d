// The effect "wave": the water starts as a standing or a solitary wave.
#pragma once

#include "analysis/wave_theory.h"

namespace tidewater::scene {

struct Effect;
struct Scene;

// The keys of [wave]; wave.cpp says what each means.
struct Wave {
    analysis::WaveKind kind = analysis::WaveKind::standing;
    double height = 0.0;  // m
    double length = 0.0;  // m, of a standing wave
    double center = 0.0;  // m, of a solitary wave
};

// The wave that the water of a scene with this effect starts as.
analysis::InitialWave initial_wave(const Scene& scene);

extern const Effect wave_effect;

}  // namespace tidewater::scene
