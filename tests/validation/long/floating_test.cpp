// Blocks that float and rise, by cell size, transfer and contact: the table of tests/validation/README.md.
#include <doctest/doctest.h>

#include <initializer_list>

#include "support/floating.h"

using namespace tidewater;
using namespace tidewater::mpm;

namespace {

const char* name_of(Transfer transfer) { return transfer == Transfer::apic ? "apic" : "restored"; }
const char* name_of(BodyContact contact) { return contact == BodyContact::stick ? "stick" : "slip"; }

}  // namespace

// Aim: 1.6 to 1.74 s. Reached by none; nearer with every halving of the cells.
TEST_CASE("the period of a heaving block comes nearer to theory with finer cells") {
    const test::FirstHeave theory = test::linear_first_heave(4.0, 0.01);
    MESSAGE("theory: ", theory.period, " s, ", theory.depth, " m down");
    for (const Transfer transfer : {Transfer::apic, Transfer::restored}) {
        for (const BodyContact contact : {BodyContact::stick, BodyContact::slip}) {
            double last = 1e9;
            for (const int cells : {20, 40, 80}) {
                test::Track track;
                const test::FirstHeave heave =
                    test::first_heave(contact, {.cells = cells, .transfer = transfer}, track);
                MESSAGE(name_of(transfer), ", ", name_of(contact), ", ", cells, " cells: ", heave.period,
                        " s (", 100.0 * (heave.period / theory.period - 1.0), " %), ", heave.depth,
                        " m down, energy at most ", track.most_energy, " J/m, ", track.deepest,
                        " cells inside");
                CHECK(heave.period > 0.99 * theory.period);
                CHECK(heave.period < last);
                CHECK(track.most_energy < 0.1);
                CHECK(track.deepest < 0.5);
                last = heave.period;
            }
            CHECK(last == doctest::Approx(theory.period).epsilon(contact == BodyContact::slip ? 0.06 : 0.1));
        }
    }
}

TEST_CASE("the rise of a submerged block comes nearer to theory with finer cells") {
    for (const double density : {500.0, 920.0}) {
        for (const BodyContact contact : {BodyContact::stick, BodyContact::slip}) {
            double last = 0.0;
            for (const int cells : {20, 40, 80}) {
                test::Track track;
                const double rise = test::rise_of(
                    density, contact, {.cells = cells, .transfer = Transfer::restored}, 0.15, track);
                MESSAGE(density, " kg/m³, ", name_of(contact), ", ", cells, " cells: ", rise);
                CHECK(rise > last);
                CHECK(rise < 1.03);
                CHECK(track.most_energy < 0.1);
                CHECK(track.deepest < 0.5);
                last = rise;
            }
            if (contact == BodyContact::slip) CHECK(last == doctest::Approx(1.0).epsilon(0.08));
        }
    }
}

TEST_CASE("a floating block has the draft of Archimedes on coarse cells too") {
    for (const Transfer transfer : {Transfer::apic, Transfer::restored}) {
        for (const BodyContact contact : {BodyContact::stick, BodyContact::slip}) {
            for (const int cells : {20, 40}) {
                test::Track track;
                const double draft =
                    test::draft_of(contact, {.length = 2.0, .cells = cells, .transfer = transfer}, track);
                MESSAGE(name_of(transfer), ", ", name_of(contact), ", ", cells, " cells: ", draft, " m, ",
                        100.0 * (draft / 0.46 - 1.0), " %, energy at most ", track.most_energy, " J/m, ",
                        track.deepest, " cells inside");
                CHECK(draft == doctest::Approx(0.46).epsilon(0.01));
            }
        }
    }
}
