// Named values of a program's state in an HDF5 file: visitors for a function that shows them one by one,
//
//     visit("position", s.position);    a vector: an array with a row per element
//     visit("time", s.time);            a single element: an array of one row
//     visit("log", s.log);              text: an array of characters
//
// so that one function serves saving and loading. Elements are numbers (float, double, 32 and 64-bit
// integers) or Eigen vectors and matrices of fixed size k, rows of k numbers as Eigen holds them (matrices
// column by column). Values read back bit by bit; arrays carry checksums. Test:
// tests/unit/io/columns_test.cpp
#pragma once

#include "io/hdf5_file.h"

namespace tidewater::io {

// An element's row: `components` numbers; 0 for a plain number.
template <class T>
struct ElementRow {
    using Number = T;
    static constexpr int components = 0;
};
template <class T>
requires(T::SizeAtCompileTime > 0) struct ElementRow<T> {
    using Number = typename T::Scalar;
    static constexpr int components = T::SizeAtCompileTime;
    static_assert(sizeof(T) == sizeof(Number) * static_cast<std::size_t>(components), "no padding");
};

class ColumnWriter {
public:
    // Makes the group, "/state" for instance. Members throw OutputError.
    ColumnWriter(Hdf5Writer& file, std::string group) : file_(file), group_(std::move(group)) {
        file_.group(group_);
    }

    template <class T>
    void operator()(const std::string& name, const std::vector<T>& column) const {
        write(name, std::span<const T>(column), Packing::none);
    }
    template <class T>
    void operator()(const std::string& name, const T& value) const {
        write(name, std::span<const T>(&value, 1), Packing::none);
    }
    void operator()(const std::string& name, const std::string& text) const {
        write(name, std::span<const char>(text), Packing::deflate);
    }

private:
    template <class T>
    void write(const std::string& name, std::span<const T> elements, Packing packing) const {
        using Row = ElementRow<T>;
        using Number = typename Row::Number;
        const auto* numbers = reinterpret_cast<const Number*>(elements.data());
        const std::span<const Number> all(numbers, elements.size_bytes() / sizeof(Number));
        file_.array<Number>(group_ + "/" + name, all, Row::components, packing);
    }

    Hdf5Writer& file_;
    std::string group_;
};

class ColumnReader {
public:
    // Members throw InputError if a value is missing, damaged or of another type.
    ColumnReader(const Hdf5Reader& file, std::string group) : file_(file), group_(std::move(group)) {}

    template <class T>
    void operator()(const std::string& name, std::vector<T>& column) const {
        using Row = ElementRow<T>;
        column.resize(file_.rows<typename Row::Number>(group_ + "/" + name, Row::components));
        read(name, std::span<T>(column));
    }
    template <class T>
    void operator()(const std::string& name, T& value) const {
        read(name, std::span<T>(&value, 1));
    }
    void operator()(const std::string& name, std::string& text) const {
        text.resize(file_.rows<char>(group_ + "/" + name));
        read(name, std::span<char>(text));
    }

private:
    template <class T>
    void read(const std::string& name, std::span<T> elements) const {
        using Row = ElementRow<T>;
        using Number = typename Row::Number;
        auto* numbers = reinterpret_cast<Number*>(elements.data());
        const std::span<Number> all(numbers, elements.size_bytes() / sizeof(Number));
        file_.fill<Number>(group_ + "/" + name, all, Row::components);
    }

    const Hdf5Reader& file_;
    std::string group_;
};

}  // namespace tidewater::io
