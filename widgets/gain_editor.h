#pragma once

#include "control/design/pid.h"
#include "widgets/display_units.h"

#include <QWidget>

#include <array>
#include <optional>

class QComboBox;
class QLabel;

namespace halbench::widgets {

class QuantityEdit;

/// Largest gains that may be set, parallel form, per radian.
struct GainLimits {
    double proportional_A_per_rad = 1000.0;
    double integral_A_per_rad_s = 10000.0;
    double derivative_As_per_rad = 100.0;
};

/// The three gains in parallel form with their units, per radian or per degree: the device's beside the
/// edited ones, with the change. The form is written above them; it is never left to guess.
class GainEditor : public QWidget {
    Q_OBJECT
public:
    explicit GainEditor(QWidget* parent = nullptr);

    void setLimits(const GainLimits& limits);
    void setAngleUnit(AngleUnit unit);
    /// Errors of control::convert when the gains have no parallel form; then nothing is shown anew.
    Result<void> setDeviceGains(const control::PidGains& gains);
    Result<void> setEditedGains(const control::PidGains& gains);
    void clearDeviceGains();

    /// Parallel, per radian.
    control::PidGains editedGains() const;
    bool isChanged() const;

Q_SIGNALS:
    void edited(); ///< by the user
    void angleUnitChanged(halbench::widgets::AngleUnit unit);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QLabel* name = nullptr;
        QuantityEdit* edit = nullptr;
        QLabel* device = nullptr;
        QLabel* change = nullptr;
    };
    static constexpr std::size_t Gains = 3;

    void layOut();
    void retranslate();
    void refreshFormats();
    void refreshComparison();
    void onEdited(std::size_t gain, double shown);
    DisplayUnit unitOf(std::size_t gain) const;

    std::array<Row, Gains> m_rows;
    std::array<double, Gains> m_edited{}; ///< per radian
    std::optional<std::array<double, Gains>> m_device;
    std::array<double, Gains> m_limits{};
    AngleUnit m_angleUnit = AngleUnit::Radian;
    QLabel* m_form = nullptr;
    QLabel* m_editedHeading = nullptr;
    QLabel* m_deviceHeading = nullptr;
    QComboBox* m_unit = nullptr;
};

} // namespace halbench::widgets
