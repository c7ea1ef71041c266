#pragma once

#include <QWidget>

#include <vector>

class QButtonGroup;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace halbench::app {

/// Pages with a button each, like tabs; where the buttons do not fit side by side they take another row, so
/// that every title is whole at every width. Thread: GUI.
class PageChooser : public QWidget {
    Q_OBJECT
public:
    explicit PageChooser(QWidget* parent = nullptr);

    void addPage(QWidget* page);
    void setTitle(QWidget* page, const QString& title, const QString& toolTip);
    void setPageEnabled(QWidget* page, bool isEnabled);
    void setCurrent(QWidget* page);
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QPushButton* buttonOf(QWidget* page) const;
    void placeButtons();

    QStackedWidget* m_pages = nullptr;
    QVBoxLayout* m_rows = nullptr; ///< of buttons
    QButtonGroup* m_group = nullptr;
    std::vector<QPushButton*> m_buttons;
};

} // namespace halbench::app
