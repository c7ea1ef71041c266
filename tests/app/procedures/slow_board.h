#pragma once

#include "tests/app/procedures/rogue_board.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace halbench::app {

/// A board whose line carries one row per control period and no more, and of which rows get lost or altered
/// on their way: `pass` is asked for each row, counted from the start of its stream, and may change the
/// angle.
class SlowBoard final : public RogueBoard {
public:
    using Pass = std::function<bool(std::size_t row, double time_s, double& position_rad)>;
    SlowBoard(std::unique_ptr<devices::Device> device, Alter alter, double rate_Hz, Pass pass)
        : RogueBoard(std::move(device), std::move(alter)), m_pass(std::move(pass)),
          m_catalogue(RogueBoard::catalogue()) {
        for (SignalSpec& signal : m_catalogue.signals) {
            signal.maxRate_Hz = std::min(signal.maxRate_Hz, rate_Hz);
        }
    }

    const devices::Catalogue& catalogue() const override { return m_catalogue; }

    Result<void> startStream(const devices::StreamRequest& request, devices::BlockSink sink) override {
        m_fastest_Hz = std::max(m_fastest_Hz, request.rate_Hz);
        return RogueBoard::startStream(request, [this, row = std::size_t{0}, sink = std::move(sink)](
                                                    const SampleBlockPtr& whole) mutable {
            if (auto rest = passed(*whole, row); rest->rows() > 0) {
                sink(rest);
            }
        });
    }

    double fastest_Hz() const { return m_fastest_Hz; } ///< that was asked for

private:
    SampleBlockPtr passed(const SampleBlock& whole, std::size_t& row) const {
        auto rest = std::make_shared<SampleBlock>(whole);
        rest->time_s.clear();
        rest->values.clear();
        const std::size_t columns = whole.layout->columns.size();
        const int position = whole.layout->indexOf("position");
        for (std::size_t i = 0; i < whole.rows(); ++i, ++row) {
            const auto from = whole.values.begin() + static_cast<std::ptrdiff_t>(i * columns);
            std::vector<double> values(from, from + static_cast<std::ptrdiff_t>(columns));
            double none = 0.0;
            double& angle_rad = position < 0 ? none : values[static_cast<std::size_t>(position)];
            if (m_pass(row, whole.time_s[i], angle_rad)) {
                rest->time_s.push_back(whole.time_s[i]);
                rest->values.insert(rest->values.end(), values.begin(), values.end());
            }
        }
        return rest;
    }

    Pass m_pass;
    devices::Catalogue m_catalogue;
    double m_fastest_Hz = 0.0;
};

} // namespace halbench::app
