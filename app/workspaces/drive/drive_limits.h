#pragma once

#include "app/workbench/drive_control.h"

#include <QWidget>

#include <string>
#include <vector>

class QCheckBox;

namespace halbench::widgets {
class NumberLabel;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// The board's limits beside what they limit, live. Changing one writes it at once, as one transaction.
class DriveLimits : public QWidget {
    Q_OBJECT

public:
    DriveLimits(Workbench& bench, const DriveControl& control, QWidget* parent = nullptr);

    /// Live values; call it ten times a second.
    void refreshLive();

Q_SIGNALS:
    void failed(const QString& text, const QString& remedy);

private:
    struct Row {
        std::string parameter;
        std::string switchParameter; ///< empty: always on
        QString title;
        QString toolTip;
        std::optional<double> (DriveLimits::*measured)() const = nullptr; ///< SI
        double factor = 1.0;                                              ///< shown = factor x SI
        QCheckBox* enabled = nullptr;
        widgets::QuantityEdit* limit = nullptr;
        widgets::NumberLabel* live = nullptr;
    };

    void addRow(Row row);
    void onValues();
    void onEntered(const Row& row);
    void showValue(Row& row);
    void followAxis();
    void refreshEnabled();
    void write(const std::string& parameter, double value);
    std::optional<double> magnitude(const std::string& role) const;
    std::optional<double> current_A() const;
    std::optional<double> largest(const char* rolePrefix) const;
    std::optional<double> temperature_degC() const;
    std::optional<double> excursion_rad() const;
    std::optional<double> speed_rad_s() const { return magnitude(m_control.axis().roles.speed); }

    Workbench& m_bench;
    const DriveControl& m_control;
    static constexpr std::size_t PositionRow = 2, SpeedRow = 3;
    std::vector<Row> m_rows;
    std::string m_axis; ///< id of the one whose windows are shown
};

} // namespace halbench::app
