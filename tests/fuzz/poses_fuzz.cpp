// Tables of poses: any text. What is read leads every axis through its rows at the times that it tells.
#include "app/documents/pose_table_file.h"

#include <cmath>
#include <cstdint>

using namespace halbench;
using namespace halbench::app;

namespace {

void requireRemedy(const Error& error) {
    if (error.message.empty() || error.hint.empty()) {
        __builtin_trap();
    }
}

/// Sizes and times at which a double holds the way through them.
bool isOrdinary(const TabledMotion& tabled) {
    double before_s = 0.0;
    for (const double arrival_s : tabled.motion.arrivals_s()) {
        if (arrival_s > 1e4 || (arrival_s > before_s && arrival_s - before_s < 1e-3)) {
            return false;
        }
        before_s = arrival_s;
    }
    for (const auto& row : tabled.table.rows) {
        for (const double value : row) {
            if (std::fabs(value) > 1e3) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    auto table = parsePoseTable(text, "fuzz.csv");
    if (!table) {
        requireRemedy(table.error());
        return 0;
    }
    auto reference = parseMoveReference("table,file=fuzz.csv,rate_m_s=1,acceleration_m_s2=10,rate_rad_s=1,"
                                        "acceleration_rad_s2=10");
    if (!table->time_s.empty()) {
        reference = parseMoveReference("table,file=fuzz.csv");
    }
    if (const auto attached = attachTable(*reference, *std::move(table)); !attached) {
        requireRemedy(attached.error());
        return 0;
    }
    const TabledMotion& tabled = *reference->table;
    if (tabled.motion.arrivals_s().size() != tabled.table.rows.size()) {
        __builtin_trap();
    }
    for (std::size_t row = 0; isOrdinary(tabled) && row < tabled.table.rows.size(); ++row) {
        for (std::size_t axis = 0; axis < tabled.motion.axisCount(); ++axis) {
            const double there = tabled.motion.at(axis, tabled.motion.arrivals_s()[row]).value;
            // Speeds of up to 1e3/1e-3 at a time that is rounded to 1e-12.
            if (!(std::fabs(there - tabled.table.rows[row][axis]) < 1e-3)) {
                __builtin_trap();
            }
        }
    }
    return 0;
}
