#pragma once

#include "app/workbench/drive_control.h"

#include <QComboBox>

namespace halbench::app {

/// In which mode the board drives. It shows what the board was told, also when it could not be told another.
class ModeBox : public QComboBox {
    Q_OBJECT

public:
    /// `key`: as the tooltip tells it.
    ModeBox(DriveControl& control, const QString& key, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;
    /// A wheel that turns while the pointer passes must not take the current from a load.
    void wheelEvent(QWheelEvent* event) override;

private:
    void refresh();
    void sayWords();

    DriveControl& m_control;
    QString m_key;
};

} // namespace halbench::app
