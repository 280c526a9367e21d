#include "particles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/types.h"
#include "io/collection.h"
#include "io/members_file.h"

namespace tidewater::postprocess {
namespace {

// α of ice by its damage, for frames without it: failed ice has 0, and p0 counts up to that at the start.
std::vector<float> alpha_of_damage(const io::Snapshot& snapshot, const mpm::IceModel& ice) {
    const double whole = std::sinh(-ice.hardening * ice.initial_alpha(snapshot.dimension));
    std::vector<float> alpha(snapshot.particle_count(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t p = 0; p < alpha.size(); ++p) {
        if (static_cast<Material>(snapshot.material[p]) != Material::ice) continue;
        const double left = 1.0 - static_cast<double>(snapshot.damage[p]);
        alpha[p] = static_cast<float>(-std::asinh(left * whole) / ice.hardening);
    }
    return alpha;
}

// p0 = κ sinh(ξ max(−α, 0)); of ice whose hardening is capped, at most that at the start.
std::vector<float> p0_of_alpha(const std::vector<float>& alpha, int dimension, const mpm::IceModel& ice) {
    const double kappa = ice.bulk_modulus(dimension);
    const double most = ice.cap_hardening ? ice.beta_p0 / ice.beta : std::numeric_limits<double>::infinity();
    std::vector<float> p0(alpha.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t p = 0; p < alpha.size(); ++p) {
        if (std::isnan(alpha[p])) continue;
        const double angle = ice.hardening * std::max(-static_cast<double>(alpha[p]), 0.0);
        p0[p] = static_cast<float>(std::min(kappa * std::sinh(angle), most));
    }
    return p0;
}

io::DerivedColumns derive(const io::Snapshot& snapshot, const mpm::IceModel& ice) {
    io::DerivedColumns derived;
    if (snapshot.damage.empty()) return derived;
    if (snapshot.alpha.empty()) derived.alpha = alpha_of_damage(snapshot, ice);
    const auto& alpha = snapshot.alpha.empty() ? derived.alpha : snapshot.alpha;
    derived.p0 = p0_of_alpha(alpha, snapshot.dimension, ice);
    return derived;
}

}  // namespace

std::vector<std::int32_t> icebergs_of(const std::filesystem::path& folder, std::size_t frame,
                                      const io::Snapshot& snapshot) {
    const auto path = folder / frame_file("members", frame, "h5");
    if (!std::filesystem::exists(path)) return {};
    const io::Members members = io::read_members(path);
    const std::uint32_t end = members.particle.empty() ? 0 : members.particle.back() + 1;
    std::vector<std::int32_t> by_id(end, -1);
    for (std::size_t m = 0; m < members.particle.size(); ++m)
        by_id[members.particle[m]] = static_cast<std::int32_t>(members.iceberg[m]);
    std::vector<std::int32_t> icebergs(snapshot.particle_count(), -1);
    for (std::size_t p = 0; p < icebergs.size(); ++p) {
        if (snapshot.id[p] < end) icebergs[p] = by_id[snapshot.id[p]];
    }
    return icebergs;
}

FrameProduct particles_product(const StageContext& context, const FrameProduct& icebergs) {
    constexpr std::array<std::string_view, 1> keys{"postprocess.decimation"};
    const int every = context.scene.postprocess.decimation;
    return {.name = "particles",
            .settings = scene::values_of(context.scene, keys) + icebergs.settings,
            .files =
                [every](std::size_t frame) {
                    return every > 0 ? std::vector{io::particles_name(frame)} : std::vector<std::string>{};
                },
            .make =
                [folder = context.folder, every, ice = scene::ice_model(context.scene)](
                    std::size_t frame, const io::Snapshot& snapshot, const Provenance& provenance) {
                    const auto write = [&](const io::Snapshot& kept) {
                        io::DerivedColumns derived = derive(kept, ice);
                        derived.iceberg = icebergs_of(folder, frame, kept);
                        io::write_particles(folder / io::particles_name(frame), kept, derived, provenance);
                    };
                    every == 1 ? write(snapshot) : write(io::thin_out(snapshot, every));
                },
            .follows = !icebergs.files(0).empty()};
}

}  // namespace tidewater::postprocess
