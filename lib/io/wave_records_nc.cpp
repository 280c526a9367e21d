#include "io/wave_records_nc.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

#include "core/files.h"
#include "io/netcdf_file.h"

namespace tidewater::io {
namespace {

void describe_file(NetcdfWriter& file, const std::string& title, const Provenance& provenance) {
    file.attribute("", "Conventions", "CF-1.8");
    file.attribute("", "title", title);
    file.attribute("", "source", provenance.program + " " + provenance.version + ", material point method");
    file.attributes(provenance);
}

int define_time(NetcdfWriter& file, std::size_t count) {
    const int time = file.dimension("time", count);
    file.variable<double>("time", {time});
    file.attribute("time", "standard_name", "time");
    file.attribute("time", "long_name", "time since the start of the simulation");
    file.attribute("time", "units", "seconds since 2000-01-01 00:00:00");
    file.attribute("time", "calendar", "proleptic_gregorian");
    file.attribute("time", "axis", "T");
    file.attribute("time", "comment", "the date is arbitrary: it is the start of the simulation");
    return time;
}

// axis: 'x' or 'y'; a coordinate of its own (of its own dimension) or of stations.
void define_place(NetcdfWriter& file, const std::string& axis, int dimension, const std::string& name) {
    file.variable<double>(axis, {dimension});
    file.attribute(axis, "standard_name", "projection_" + axis + "_coordinate");
    file.attribute(axis, "long_name", name);
    file.attribute(axis, "units", "m");
}

void describe_elevation(NetcdfWriter& file) {
    file.attribute("eta", "standard_name", "sea_surface_height_above_mean_sea_level");
    file.attribute("eta", "long_name", "elevation of the water surface above the still level");
    file.attribute("eta", "units", "m");
    file.missing_is_nan("eta");
}

}  // namespace

void write_gauges_nc(const std::filesystem::path& path, const GaugeRecords& records,
                     const Provenance& provenance) {
    if (records.time.empty() || records.stations.empty()) return;
    std::size_t longest = 1;
    for (const Station& station : records.stations) longest = std::max(longest, station.name.size());
    std::vector<double> x, y, elevation;
    std::string names;
    for (const Station& station : records.stations) {
        assert(station.elevation.size() == records.time.size());
        x.push_back(station.x);
        y.push_back(station.y);
        elevation.insert(elevation.end(), station.elevation.begin(), station.elevation.end());
        names += station.name + std::string(longest - station.name.size(), '\0');
    }
    PartFile part(path);
    NetcdfWriter file(part.part_path());
    describe_file(file, records.title, provenance);
    file.attribute("", "featureType", "timeSeries");
    const int stations = file.dimension("station", records.stations.size());
    const int letters = file.dimension("station_name_length", longest);
    const int time = define_time(file, records.time.size());
    file.variable<char>("station_name", {stations, letters});
    file.attribute("station_name", "cf_role", "timeseries_id");
    file.attribute("station_name", "long_name", "name of the gauge");
    define_place(file, "x", stations, "distance along the tank");
    define_place(file, "y", stations, "distance across the tank");
    file.variable<double>("eta", {stations, time});
    describe_elevation(file);
    file.attribute("eta", "coordinates", "x y station_name");
    file.end_definitions();
    file.values<double>("time", records.time);
    file.values<char>("station_name", std::span(names.data(), names.size()));
    file.values<double>("x", x);
    file.values<double>("y", y);
    file.values<double>("eta", elevation);
    file.close();
    part.commit();
}

void write_space_time_nc(const std::filesystem::path& path, const SpaceTime& record,
                         const Provenance& provenance) {
    if (record.time.empty() || record.x.empty()) return;
    assert(record.elevation.size() == record.time.size() * record.x.size());
    PartFile part(path);
    NetcdfWriter file(part.part_path());
    describe_file(file, record.title, provenance);
    const int time = define_time(file, record.time.size());
    const int along = file.dimension("x", record.x.size());
    define_place(file, "x", along, "distance along the tank");
    file.attribute("x", "axis", "X");
    file.variable<float>("eta", {time, along});
    describe_elevation(file);
    file.end_definitions();
    file.values<double>("time", record.time);
    file.values<double>("x", record.x);
    file.values<float>("eta", record.elevation);
    file.close();
    part.commit();
}

}  // namespace tidewater::io
