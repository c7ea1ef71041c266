#pragma once

#include <QWidget>

#include <vector>

class QButtonGroup;
class QPushButton;
class QSplitter;
class QStackedWidget;
class QVBoxLayout;

namespace halbench::app {

/// Pages with a button each, like tabs; where the buttons do not fit side by side they take another row, so
/// that every title is whole at every width. Two pages can be shown side by side where there is room. Thread:
/// GUI.
class PageChooser : public QWidget {
    Q_OBJECT
public:
    explicit PageChooser(QWidget* parent = nullptr);

    void addPage(QWidget* page);
    void setTitle(QWidget* page, const QString& title, const QString& toolTip);
    void setPageEnabled(QWidget* page, bool isEnabled);
    void setCurrent(QWidget* page);
    /// The keyboard goes to the button of the page that is shown, where a key changes nothing.
    void focusCurrent();
    /// From this width of the pages on, the second stands beside the first, under one button with both
    /// titles.
    void pairWhenWide(QWidget* first, QWidget* second, int least_px);
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Page {
        QWidget* content;
        QPushButton* button;
        QString title;
    };
    /// The first page's place holds the splitter, the second's a box that is empty while both are in that.
    struct Pair {
        QWidget* first = nullptr;
        QWidget* second = nullptr;
        QSplitter* splitter = nullptr;
        QWidget* box = nullptr;
        int least_px = 0;
        bool isTogether = false;
    };
    Page& pageOf(QWidget* content);
    bool isBeside(const Page& page) const; ///< the first of the pair, under its button
    void refreshTitles();
    void placeButtons();
    void placePair();
    int narrowest_px() const;

    QStackedWidget* m_pages = nullptr;
    QVBoxLayout* m_rows = nullptr; ///< of buttons
    QButtonGroup* m_group = nullptr;
    std::vector<Page> m_content; ///< in the order of the stack
    Pair m_pair;
};

} // namespace halbench::app
