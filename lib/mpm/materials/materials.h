// The table of materials: each material of particles that the engine advances is listed once.
//
// A new material is a header of its own with an entry like WaterMaterial or IceMaterial, and its type in
// `Materials` below. An entry M provides
//
//     M::material                            the number that snapshots store (core/types.h)
//     M::model(parameters)                   its constants in the parameters of a run
//     M::make_columns(model, count, to)      makes the columns of Particles that it keeps, at rest
//     M::sound_speed(model, findings)        max. speed of its waves, m/s
//     M::stored_energy(model, particles, first, count, energy)  elastic energy of a batch, particle by
//     particle, J M::complaint(particles, p, may_fail)   what makes a state unusable M::Step(model, gravity,
//     cell size, interval)  the constants of one step
//         reads_crowding()                       whether the kernel reads the crowding lane
//     M::Kernel{particles, step}             update(first, count, batch) of the pass, and its findings()
//
// Dispatch is static: with_material picks the entry once per block of particles, and no kernel branches on
// the material. Rigid bodies have no particles and are not in the table (mpm/bodies/rigid.h).
#pragma once

#include <tuple>
#include <type_traits>

#include "mpm/materials/ice_material.h"
#include "mpm/materials/water_material.h"

namespace tidewater::mpm {

template <int D, class Real>
using Materials = std::tuple<WaterMaterial<D, Real>, IceMaterial<D, Real>>;

// Calls visit(std::type_identity<M>{}) with the entry M of a material, if it has one.
template <int D, class Real, class Visit>
void with_material(Material material, const Visit& visit) {
    [&]<class... M>(std::type_identity<std::tuple<M...>>) {
        (void)((material == M::material && (visit(std::type_identity<M>{}), true)) || ...);
    }(std::type_identity<Materials<D, Real>>{});
}

// The constants of one step of every material.
template <class Table>
struct StepOfEach;
template <class... M>
struct StepOfEach<std::tuple<M...>> {
    std::tuple<typename M::Step...> of;

    template <class Parameters>
    StepOfEach(const Parameters& parameters, double cell_size, const Interval& interval)
        : of(typename M::Step(M::model(parameters), parameters.gravity, cell_size, interval)...) {}

    template <class Entry>
    const typename Entry::Step& step() const {
        return std::get<typename Entry::Step>(of);
    }
    bool reads_crowding() const { return (std::get<typename M::Step>(of).reads_crowding() || ...); }
};
template <int D, class Real>
using MaterialSteps = StepOfEach<Materials<D, Real>>;

}  // namespace tidewater::mpm
