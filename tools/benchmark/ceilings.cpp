// tidewater-ceilings: what one core of this machine can do at most, as CSV. See README.md and roofline.md.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

// Bytes in the target's widest vector.
#if defined(__AVX512F__)
constexpr int widest = 64;
#elif defined(__AVX__)
constexpr int widest = 32;
#else
constexpr int widest = 16;
#endif

template <int Bytes>
struct Wide {
    using Type [[gnu::vector_size(Bytes)]] = float;
};

// The compiler must take memory for read and written here.
void keep(void* memory) { asm volatile("" : : "g"(memory) : "memory"); }

// And this vector for changed, in a register.
template <class Vector>
Vector opaque(Vector vector) {
    asm volatile("" : "+v"(vector));
    return vector;
}

// Calls body(0), body(1), ... body(Count − 1), written out: GCC would keep arrays of vectors in memory.
template <int Count, class Body>
void unrolled(const Body& body) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (body(I), ...); }
    (std::make_index_sequence<Count>{});
}

// Least seconds of many short runs, work(0), work(1), ...: what other programs on the machine take away only
// adds, and a run of about a millisecond often has a core for itself even where they take turns.
template <class Work>
double least_seconds(const Work& work, long repeats = 300) {
    double least = std::numeric_limits<double>::max();
    for (long n = 0; n < repeats; ++n) {
        const auto start = std::chrono::steady_clock::now();
        work(n);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        least = std::min(least, elapsed.count());
    }
    return least;
}

void print(const std::string& ceiling, const std::string& detail, double value, const char* unit) {
    std::printf("%s,%s,%.4g,%s\n", ceiling.c_str(), detail.c_str(), value, unit);
    std::fflush(stdout);
}

// Multiply-adds x ← a x + b of independent vectors in registers, more than two units of latency 4 need; of
// this width and all wider ones.
template <int Bytes>
void measure_multiply_add() {
    using Vector = typename Wide<Bytes>::Type;
    constexpr int chains = Bytes == 64 ? 16 : 12;
    constexpr long rounds = 200'000;
    std::array<float, 2> factors{0.999F, 1e-3F};
    keep(factors.data());
    std::array<Vector, chains> x{};
    const double seconds = least_seconds([&](long) {
        const Vector a = Vector{} + factors[0], b = Vector{} + factors[1];
        std::array<Vector, chains> y = x;
        for (long n = 0; n < rounds; ++n) {
            unrolled<chains>([&](std::size_t i) { y[i] = opaque<Vector>(a * y[i] + b); });
        }
        x = y;
        keep(x.data());
    });
    const double flops = 2.0 * chains * (Bytes / 4.0) * rounds;
    print("multiply_add", "float; " + std::to_string(8 * Bytes) + " bits", 1e-9 * flops / seconds, "GFLOP/s");
    if constexpr (2 * Bytes <= widest) measure_multiply_add<2 * Bytes>();
}

// The same from a plain loop over floats, as the compiler makes it: eight multiply-adds to a load and a
// store.
void measure_plain_loop() {
    constexpr int count = 256;
    constexpr long rounds = 20'000;
    std::array<float, 2> factors{0.999F, 1e-3F};
    keep(factors.data());
    alignas(64) std::array<float, count> x{};
    const double seconds = least_seconds([&](long) {
        const float a = factors[0], b = factors[1];
        for (long n = 0; n < rounds; ++n) {
            for (float& value : x)
                for (int k = 0; k < 8; ++k) value = a * value + b;
            keep(x.data());
        }
    });
    print("multiply_add", "float; plain loop", 1e-9 * 16.0 * count * rounds / seconds, "GFLOP/s");
}

// Each value of an array is read, changed and written back. Counts both ways. A small array is gone through
// several times in a row, of a large one a window after the other, so that it has left all smaller caches
// when its turn comes.
void measure_stream(std::size_t kibibytes) {
    std::vector<float> data(kibibytes * 256, 1.0F);
    constexpr std::size_t most = 8192 * 256;
    const std::size_t window = std::min(data.size(), most), passes = most / window;
    const auto windows = static_cast<long>(data.size() / window);
    const double seconds = least_seconds(
        [&](long n) {
            float* first = data.data() + static_cast<std::size_t>(n % windows) * window;
            for (std::size_t pass = 0; pass < passes; ++pass) {
                for (float* value = first; value != first + window; ++value) *value += 1.0F;
                keep(first);
            }
        },
        std::max(300L, 3 * windows));
    print("read_and_write", std::to_string(kibibytes) + " KiB",
          1e-9 * 2.0 * sizeof(float) * static_cast<double>(window * passes) / seconds, "GB/s");
}

// Rows of 64 bytes, at these offsets in units of 16 bytes, are read, changed and written back in pieces.
template <int Bytes>
double nanoseconds_per_row(const std::vector<int>& offsets) {
    using Vector = typename Wide<Bytes>::Type;
    constexpr int pieces = 64 / Bytes;
    const long rounds = 300'000 / static_cast<long>(offsets.size());
    alignas(64) static std::array<std::byte, 32768> memory{};
    std::array<float, 1> one{1.0F};
    keep(one.data());
    const double seconds = least_seconds([&](long) {
        const Vector add = Vector{} + one[0];
        for (long n = 0; n < rounds; ++n) {
            for (const int offset : offsets) {
                std::byte* row = memory.data() + 16 * offset;
                std::array<Vector, pieces> values;
                unrolled<pieces>([&](std::size_t i) {
                    Vector value;
                    std::memcpy(&value, row + i * Bytes, Bytes);
                    values[i] = opaque<Vector>(value + add);
                });
                unrolled<pieces>([&](std::size_t i) { std::memcpy(row + i * Bytes, &values[i], Bytes); });
            }
            keep(memory.data());
        }
    });
    return 1e9 * seconds / (static_cast<double>(rounds) * static_cast<double>(offsets.size()));
}

struct Rows {
    const char* name;
    std::vector<int> offsets;  // in 16 bytes
};

// Nine rows per particle, three to a plane of 6³ nodes (16 bytes each), as quadratic P2G in a block of 4³
// cells; the cell is `cell(particle)`.
template <class Cell>
std::vector<int> particle_rows(const Cell& cell) {
    std::vector<int> offsets;
    for (int particle = 0; particle < 256; ++particle) {
        const std::array<int, 3> at = cell(particle);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) offsets.push_back(((at[0] + i) * 6 + at[1] + j) * 6 + at[2]);
    }
    return offsets;
}

std::vector<Rows> row_patterns() {
    const auto repeated = [](const auto& offset) {
        std::vector<int> offsets;
        for (int n = 0; n < 240; ++n) offsets.push_back(offset(n));
        return offsets;
    };
    const auto odd = [](int n) { return 1 + 2 * (n % 2); };
    unsigned state = 1;
    const auto random = [&] { return static_cast<int>((state = state * 1664525U + 1013904223U) >> 30); };
    const auto eight_to_a_cell = [](int particle) {
        return std::array{particle / 128 % 4, particle / 32 % 4, particle / 8 % 4};
    };
    return {{"apart; aligned", repeated([](int n) { return 8 * n; })},
            {"apart; odd multiples of 16", repeated([&](int n) { return 8 * n + odd(n); })},
            {"as the last; aligned", repeated([](int) { return 0; })},
            {"as the last; odd multiple of 16", repeated([](int) { return 1; })},
            {"32 bytes on from the last and back; odd multiples of 16", repeated(odd)},
            {"16 bytes on from the last and back", repeated([](int n) { return 1 + n % 2; })},
            {"nine of a particle; all in one cell", particle_rows([](int) {
                 return std::array{1, 1, 1};
             })},
            {"nine of a particle; eight to a cell", particle_rows(eight_to_a_cell)},
            {"nine of a particle; cells at random", particle_rows([&](int) {
                 return std::array{random(), random(), random()};
             })}};
}

// A row in pieces of this width and of all wider ones.
template <int Bytes>
void measure_row(const Rows& rows) {
    print("row_of_64_bytes",
          std::string(rows.name) + "; " + std::to_string(64 / Bytes) + " x " + std::to_string(8 * Bytes) +
              " bits",
          nanoseconds_per_row<Bytes>(rows.offsets), "ns");
    if constexpr (2 * Bytes <= widest) measure_row<2 * Bytes>(rows);
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    std::string model, family, number;
    for (std::string line; std::getline(info, line);) {
        const std::string value = line.substr(std::min(line.size(), line.find(':') + 1));
        if (model.empty() && line.starts_with("model name")) model = value;
        if (family.empty() && line.starts_with("cpu family")) family = value;
        if (number.empty() && line.starts_with("model\t")) number = value;
    }
    return model + ", family" + family + ", model" + number;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1) {
        const bool help = std::string(argv[1]) == "--help";
        std::fprintf(help ? stdout : stderr,
                     "tidewater-ceilings: takes no options; writes CSV for one core, about half a minute\n");
        return help ? 0 : 2;
    }
    std::printf("# processor:%s\n# compiler: %s\n# flags: %s\n", processor().c_str(), __VERSION__,
                TIDEWATER_FLAGS);
    std::printf("ceiling,detail,value,unit\n");
    measure_multiply_add<16>();
    measure_plain_loop();
    for (const std::size_t kibibytes : {16UL, 32UL, 128UL, 512UL, 1024UL, 2048UL, 8192UL, 16384UL, 65536UL,
                                        262144UL, 1048576UL, 2097152UL}) {
        measure_stream(kibibytes);
    }
    for (const Rows& rows : row_patterns()) measure_row<16>(rows);
}
