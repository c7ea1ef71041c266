// Stands in for the fuzzer: each file of a corpus, whole and cut off at up to 32 places, goes to the target
// once.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t Cuts = 32;

std::vector<std::uint8_t> contentOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Each cut is a copy of its own size: what reads behind it is found by the sanitizer.
void feed(const std::vector<std::uint8_t>& content) {
    for (std::size_t cut = 0; cut <= Cuts; ++cut) {
        const auto size = static_cast<std::ptrdiff_t>(content.size() * cut / Cuts);
        const std::vector<std::uint8_t> piece(content.begin(), content.begin() + size);
        (void)LLVMFuzzerTestOneInput(piece.data(), piece.size());
    }
}

} // namespace

int main(int count, char** arguments) {
    std::size_t files = 0;
    for (int i = 1; i < count; ++i) {
        for (const auto& entry : std::filesystem::directory_iterator(arguments[i])) {
            feed(contentOf(entry.path()));
            ++files;
        }
    }
    std::printf("%zu files\n", files);
    return files > 0 ? 0 : 1; // an empty corpus shows nothing
}
