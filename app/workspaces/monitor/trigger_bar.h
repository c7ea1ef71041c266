#pragma once

#include "app/workbench/display_quantity.h"
#include "app/workbench/live_trigger.h"
#include "devices/device.h"
#include "widgets/theme/theme_style.h"

#include <QWidget>

class QAction;
class QComboBox;
class QHBoxLayout;
class QPushButton;

namespace halbench::widgets {
class ElidedLabel;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

class FieldGrid;

/// The oscilloscope trigger in a line above the plots: what is waited for and what it does, in words; the
/// other settings in a line below when asked for (resources/help/monitor.md, "Trigger").
class TriggerBar : public QWidget {
    Q_OBJECT

public:
    /// `again`: the action that waits anew.
    TriggerBar(QAction& again, QWidget* parent);

    /// Whose signals can be the source; without a role `reference` no set-point is offered.
    /// `derived`: those that the device itself does not have.
    void setCatalogue(const devices::Catalogue& catalogue, const DisplayUnits& units,
                      std::vector<std::string> derived = {});
    void setChoice(const TriggerChoice& choice);
    const TriggerChoice& choice() const { return m_choice; }
    /// `sentence`: all of it, for who asks.
    void setState(const QString& words, const QString& sentence, widgets::Role role);
    /// "Speed rises through 10 r/min", "the set-point changes".
    QString eventWords() const;

Q_SIGNALS:
    void edited();          ///< choice() is another
    void sourceChosen();    ///< likewise, and the level is that of another signal
    void middleRequested(); ///< the level into the middle of what the source does

private:
    enum Field { Level, Hysteresis, Window, Before, HoldOff, Fields };
    void buildEvent(QHBoxLayout& line);
    void onFrom(bool isBoard);
    void buildSettings(FieldGrid& grid);
    void watch(Field field, widgets::QuantityEdit* box);
    void onEdited(Field field, double shown);
    void onSource(int index);
    void dressFields();
    void showChoice();
    void fillSources();
    void dressForBoard();
    DisplayQuantity shown() const;

    devices::Catalogue m_catalogue;
    std::vector<std::string> m_derived;
    QString m_toolTips[Fields]; ///< of the fields while they can be used
    DisplayUnits m_units;
    TriggerChoice m_choice;
    QComboBox* m_from = nullptr;
    QComboBox* m_mode = nullptr;
    QComboBox* m_source = nullptr;
    QComboBox* m_slope = nullptr;
    QPushButton* m_middle = nullptr;
    widgets::QuantityEdit* m_numbers[Fields] = {};
    widgets::ElidedLabel* m_state = nullptr;
};

} // namespace halbench::app
