// set_hdf5 FILE NAME VALUE: replaces a root attribute (a number or a text), or the numbers of an array whose
// path begins with /. For tests of what a program says to a file that has valid checksums but is not its own.
#include <hdf5.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

bool set_attribute(hid_t file, const char* name, std::string value) {
    const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    bool written = false;
    if (H5Tget_class(type) == H5T_STRING) {
        value.resize(H5Tget_size(type), '\0');
        written = H5Awrite(attribute, type, value.data()) >= 0;
    } else {
        const double number = std::atof(value.c_str());
        written = H5Awrite(attribute, H5T_NATIVE_DOUBLE, &number) >= 0;
    }
    return H5Tclose(type) >= 0 && H5Aclose(attribute) >= 0 && written;
}

bool set_array(hid_t file, const char* path, const std::string& value) {
    const hid_t array = H5Dopen2(file, path, H5P_DEFAULT);
    const hid_t space = H5Dget_space(array);
    const std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)),
                                      std::atof(value.c_str()));
    const bool written =
        H5Dwrite(array, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0;
    return H5Sclose(space) >= 0 && H5Dclose(array) >= 0 && written;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return std::fprintf(stderr, "set_hdf5 FILE NAME VALUE\n"), 2;
    const hid_t file = H5Fopen(argv[1], H5F_ACC_RDWR, H5P_DEFAULT);
    const bool set =
        argv[2][0] == '/' ? set_array(file, argv[2], argv[3]) : set_attribute(file, argv[2], argv[3]);
    return H5Fclose(file) >= 0 && set ? 0 : 1;
}
