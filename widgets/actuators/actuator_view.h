#pragma once

#include "widgets/theme/theme.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QPainter;

namespace halbench::widgets {

/// Latest values of the connected device in SI units, by role; by name where its profile gives none. Empty
/// where the device has no such value, or none that is finite has arrived.
struct ActuatorValues {
    std::function<std::optional<double>(const std::string& role)> signal;
    std::function<std::optional<double>(const std::string& role)> parameter;
};

/// A direction of a rotor's shaft, and how much data with it are wanted: 0 ... 1.
struct WantedShaft {
    double theta_rad = 0.0; ///< from Z
    double phi_rad = 0.0;   ///< from X
    double share = 0.0;
};

/// Live picture of one actuator. Its actions (QWidget::actions()) are the commands and choices that belong to
/// it. Thread: GUI.
class ActuatorPicture : public QWidget {
public:
    using QWidget::QWidget;

    virtual void showSettings(const ActuatorValues& values) = 0; ///< parameters were read or written
    virtual void showSamples(const ActuatorValues& values) = 0;
    virtual void setStale(bool isStale) = 0;       ///< the values are the last ones known
    virtual void clear() = 0;                      ///< another device: nothing is known
    virtual QString numbers() const { return {}; } ///< text below the picture
    /// Where a calibration wants data; a picture of another motion shows nothing of it.
    virtual void showWanted(const std::vector<WantedShaft>& /*shafts*/) {}

    /// Paints the picture into a rectangle of any size, for files; empty: it cannot be saved.
    using Drawing = std::function<void(QPainter& painter, const Theme& theme, const QSizeF& size)>;
    virtual Drawing drawing() const { return {}; }
};

/// Row of the registry of views: one per actuator.
struct ActuatorView {
    std::string id;
    std::vector<std::string> needed; ///< roles of signals without which nothing can be drawn
    std::vector<std::string> wished; ///< of further signals, shown where the device has them
    std::function<ActuatorPicture*(QWidget* parent)> make;
};

} // namespace halbench::widgets
