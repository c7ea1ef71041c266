#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QPushButton;

namespace halbench::widgets {

/// What an empty panel is for, and the one action that fills it.
class EmptyState : public QWidget {
    Q_OBJECT
public:
    explicit EmptyState(QWidget* parent = nullptr);

    /// Without an `actionText` there is no button. `shortcut` stands in the button's tooltip.
    void setWords(const QString& title, const QString& purpose, const QString& actionText = {},
                  const QString& shortcut = {});
    void setIconName(const QString& name); ///< of widgets/theme/icons.h

Q_SIGNALS:
    void actionTriggered();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    QString m_icon;
    QLabel* m_symbol = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_purpose = nullptr;
    QPushButton* m_action = nullptr;
};

} // namespace halbench::widgets
