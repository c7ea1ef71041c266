#include "devices/xcp/description_cache.h"

#include "devices/xcp/a2l.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace halbench::devices::xcp {

namespace {

constexpr std::size_t MaxWord = 1024; // names and EPKs are not read longer either

/// FNV-1a, 64 bits: tells a damaged file, not a forged one.
std::uint64_t hashOf(const std::string& text) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const char c : text) {
        hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3ULL;
    }
    return hash;
}

bool isWord(const std::string& text) {
    return !text.empty() && text.size() <= MaxWord &&
           std::none_of(text.begin(), text.end(), [](char c) { return static_cast<std::uint8_t>(c) < 0x20; });
}

bool isKeepable(const std::string& folder, const DescriptionKey& key) {
    return !folder.empty() && isWord(key.name) && isWord(key.epk) && key.octets > 0 &&
           key.octets <= MaxA2lSize;
}

constexpr const char* Format = "halbench.description-cache/1";
constexpr const char* Extension = ".description";

std::string headerOf(const DescriptionKey& key, const std::string& text) {
    const std::string head = fmt::format("{}\n{}\n{}\n", Format, key.name, key.epk);
    return fmt::format("{}{} {:016x}\n", head, text.size(), hashOf(head + text));
}

std::optional<std::string> contentOf(const std::string& path, std::size_t octets) {
    std::ifstream file(path, std::ios::binary);
    std::string content(octets + 1, '\0'); // one more shows a file that is too long
    file.read(content.data(), static_cast<std::streamsize>(content.size()));
    if (file.gcount() != static_cast<std::streamsize>(octets)) {
        return std::nullopt;
    }
    content.pop_back();
    return content;
}

Result<void> writeFile(const std::string& path, const std::string& content) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) {
        return failure(ErrorCode::FileSystem, fmt::format("cannot write '{}'", path),
                       "free disk space or make the folder writable");
    }
    return {};
}

} // namespace

std::string DescriptionCache::pathOf(const DescriptionKey& key) const {
    const std::uint64_t hash = hashOf(fmt::format("{}\n{}\n{}", key.name, key.epk, key.octets));
    return fmt::format("{}/{:016x}{}", m_folder, hash, Extension);
}

std::optional<std::string> DescriptionCache::find(const DescriptionKey& key) const {
    if (!isKeepable(m_folder, key)) {
        return std::nullopt;
    }
    const std::size_t header = headerOf(key, std::string(key.octets, ' ')).size();
    std::optional<std::string> content = contentOf(pathOf(key), header + key.octets);
    if (!content) {
        return std::nullopt;
    }
    std::string text = content->substr(header);
    if (content->compare(0, header, headerOf(key, text)) != 0) {
        return std::nullopt;
    }
    return text;
}

std::optional<std::string> DescriptionCache::epkBefore(const DescriptionKey& key) const {
    namespace fs = std::filesystem;
    std::optional<std::string> before;
    fs::file_time_type newest = fs::file_time_type::min();
    std::error_code error;
    for (fs::directory_iterator entry(m_folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code unknown;
        const fs::file_time_type written = entry->last_write_time(unknown);
        std::ifstream file(entry->path(), std::ios::binary);
        std::string format;
        std::string name;
        std::string epk;
        const bool isKept = entry->path().extension() == Extension && std::getline(file, format) &&
                            format == Format && std::getline(file, name) && std::getline(file, epk);
        if (isKept && !unknown && name == key.name && isWord(epk) && epk != key.epk && written >= newest) {
            newest = written;
            before = epk;
        }
    }
    return before;
}

Result<bool> DescriptionCache::store(const DescriptionKey& key, const std::string& text) const {
    if (!isKeepable(m_folder, key) || text.size() != key.octets) {
        return false;
    }
    std::error_code error;
    std::filesystem::create_directories(m_folder, error); // what is wrong with it shows at the file
    const std::string path = pathOf(key);
    const std::string partial = path + ".partial";
    Result<void> written = writeFile(partial, headerOf(key, text) + text);
    if (written) {
        std::filesystem::rename(partial, path, error);
        if (!error) {
            return true;
        }
        written = failure(ErrorCode::FileSystem, fmt::format("cannot rename '{}'", partial),
                          "make the folder writable");
    }
    std::filesystem::remove(partial, error);
    return failure(written.error());
}

} // namespace halbench::devices::xcp
