// Records of the water surface as NetCDF files by the CF conventions 1.8, which xarray, ncview, Panoply and
// others open with decoded time.
//
// Common: the coordinate time, "seconds since 2000-01-01 00:00:00" of the proleptic Gregorian calendar, where
// the date is arbitrary and stands for the start of the simulation, since CF knows no time without one; the
// variable eta (m), sea_surface_height_above_mean_sea_level, the still level being the mean; NaN: dry, or
// covered by ice or a block; the provenance as attributes of the file.
//
// gauges:      featureType timeSeries: eta(station, time), with x(station), y(station) (m, along the tank and
//              across it; 0 in 2D), station_name(station, …) as cf_role timeseries_id
// space–time:  a field along a line: eta(time, x), with the coordinate x(x) (m)
//
// The format is NetCDF classic with 64-bit offsets; equal records with equal provenance are equal bytes.
//
// Test: tests/unit/io/wave_records_nc_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

struct Station {
    std::string name;               // "x=2"
    double x = 0.0, y = 0.0;        // m
    std::vector<double> elevation;  // η, m; NaN: dry
};

struct GaugeRecords {
    std::string title;
    std::vector<double> time;  // s; rising
    std::vector<Station> stations;
};

// Every station has an elevation per time. Records without times or stations are no file: nothing is written.
// Throws OutputError.
void write_gauges_nc(const std::filesystem::path& path, const GaugeRecords& records,
                     const Provenance& provenance);

struct SpaceTime {
    std::string title;
    std::vector<double> time;      // s; rising
    std::vector<double> x;         // m; rising
    std::vector<float> elevation;  // η, m; time by time, each with an entry per x; NaN: none
};

// Likewise.
void write_space_time_nc(const std::filesystem::path& path, const SpaceTime& record,
                         const Provenance& provenance);

}  // namespace tidewater::io
