#pragma once

#include "app/window/preferences.h"
#include "app/workspaces/workbench.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace halbench::app {

/// Theme, language, units and the lock-out after a stop. Changes nothing by itself; carries a small STOP.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    PreferencesDialog(const Preferences& preferences, Workbench& bench, QWidget* parent);

    /// The preferences it was given, with what the user chose.
    Preferences chosen() const;

private:
    void addLook(QFormLayout& form);
    void addUnits(QFormLayout& form);
    void addLockOut(QFormLayout& form);
    void addButtons(QFormLayout& form, Workbench& bench);
    QComboBox* addChoice(QFormLayout& form, const QString& label, const QString& toolTip);

    Preferences m_before;
    QComboBox* m_theme = nullptr;
    QComboBox* m_language = nullptr;
    QComboBox* m_angle = nullptr;
    QComboBox* m_speed = nullptr;
    QSpinBox* m_lockOut_ms = nullptr;
};

} // namespace halbench::app
