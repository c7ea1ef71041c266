#pragma once

#include <unistd.h>

#include <fstream>

namespace halbench {

/// Resident memory of this process, in 10^6 octets.
inline double memoryInUse_MB() {
    std::ifstream file("/proc/self/statm");
    double total_pages = 0.0;
    double resident_pages = 0.0;
    file >> total_pages >> resident_pages;
    return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

} // namespace halbench
