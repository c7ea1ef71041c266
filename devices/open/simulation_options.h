#pragma once

#include "devices/device_uri.h"
#include "devices/simulated/simulated_model.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// Options of a simulated device's address, each with its key, unit and range: `sim:htm?J=1e-4` in rows to be
/// edited. Source: resources/help/command-line.md.
class SimulationOptions {
public:
    struct Row {
        OverrideSpec spec;
        std::string value; ///< as written; empty: the standard value, or drawn from the seed
    };

    /// Nothing of an address that names no simulated device, or one without a table of keys.
    static std::optional<SimulationOptions> of(const std::string& address);

    /// Every key of the device in the order of the help page; then those of the address that it does not
    /// know.
    const std::vector<Row>& rows() const { return m_rows; }
    void set(std::size_t row, const std::string& value);
    void clear();
    std::string address() const;
    /// Errors: UnknownName, InvalidInput, NotFinite, OutOfRange; the message names the key.
    Result<void> check() const;

private:
    SimulationOptions() = default;

    std::string m_device; ///< "sim:htm"
    std::vector<Row> m_rows;
};

} // namespace halbench::devices
