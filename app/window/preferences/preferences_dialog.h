#pragma once

#include "app/window/preferences/preferences.h"
#include "app/workbench/workbench.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace halbench::app {

class RecordingFields;

/// Theme, language, units, the lock-out after a stop, the history's room on the disk, names of recordings and
/// how long they are kept. Changes nothing by
/// itself; carries a small STOP.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    /// `history_bytes`: what the history has on the disk now.
    PreferencesDialog(const Preferences& preferences, Workbench& bench, std::uint64_t history_bytes,
                      QWidget* parent);

    /// The preferences it was given, with what the user chose.
    Preferences chosen() const;

private:
    void addLook(QFormLayout& form);
    void addUnits(QFormLayout& form);
    void addLockOut(QFormLayout& form);
    void addHistory(QFormLayout& form, std::uint64_t history_bytes);
    void addButtons(QFormLayout& form, Workbench& bench);
    QComboBox* addChoice(QFormLayout& form, const QString& label, const QString& toolTip);

    Preferences m_before;
    QComboBox* m_theme = nullptr;
    QComboBox* m_language = nullptr;
    QComboBox* m_angle = nullptr;
    QComboBox* m_speed = nullptr;
    QComboBox* m_frequency = nullptr;
    QSpinBox* m_lockOut_ms = nullptr;
    QSpinBox* m_history_GB = nullptr;
    RecordingFields* m_recordings = nullptr;
};

} // namespace halbench::app
