#include "html_page.hpp"

#include "mathml.hpp"
#include "svg.hpp"

namespace blossom::worked {

namespace {

// Without '<', '>' and '&': an XML writer would escape them, and HTML does not unescape them in a style.
constexpr const char* page_style =
    "*{box-sizing:border-box}"
    "html{color-scheme:light dark;-webkit-text-size-adjust:100%}"
    "body{margin:0;background:var(--paper);color:var(--ink);"
    "font:1.06rem/1.6 Georgia,'Times New Roman','DejaVu Serif',serif}"
    "main,nav{max-width:46rem;margin:0 auto;padding:0 1rem}"
    "nav{padding-top:1rem;font-size:.95rem}nav a{margin-right:1.2rem;display:inline-block;padding:.3rem 0}"
    "a{color:var(--curve)}"
    "h1{font-size:1.7rem;line-height:1.25;margin:1.4rem 0 1rem}"
    "h2{font-size:1.25rem;line-height:1.3;margin:2.2rem 0 .8rem;border-bottom:1px solid var(--faint);"
    "padding-bottom:.25rem}"
    "section.result{--paper:var(--tint);background:var(--tint);padding:.2rem 1rem "
    ".8rem;border-radius:.4rem;margin-top:2.2rem}"
    "section.result h2{margin-top:.8rem}"
    ".together{white-space:nowrap}.source,figcaption{color:var(--soft);font-size:.95rem}"
    "math{font-family:'Latin Modern Math','STIX Two Math',Cambria Math,math;font-size:1.08em}"
    ".formula{display:grid;grid-template-columns:auto "
    "1fr;column-gap:.15em;row-gap:.55em;align-items:baseline;"
    "margin:.8rem 0 .8rem 1.2rem;line-height:1.9;overflow-x:auto;overflow-y:hidden}"
    ".formula .left{grid-column:1}.formula .right{grid-column:2;padding-left:1.4em;text-indent:-1.4em}"
    ".formula .left:only-child{grid-column:1 / 3}"
    ".formula math{text-indent:0;margin:.18em 0}"
    "figure{margin:1.4rem 0}figcaption{margin:.4rem 0}"
    ".wide{overflow-x:auto}"
    "svg{display:block;margin:0 auto}svg.picture{width:100%;height:auto;max-width:38rem}"
    "table{border-collapse:collapse;min-width:min(100%,26rem)}"
    "th,td{padding:.35rem .8rem;text-align:left;border-bottom:1px solid var(--faint);white-space:nowrap}"
    "th{font-weight:600;border-bottom:2px solid var(--soft)}"
    "details{margin:.6rem 0}summary{cursor:pointer;color:var(--curve);padding:.3rem 0}"
    ".holds::before{content:'✓ ';color:var(--second)}.fails::before{content:'✗ ';color:var(--result)}"
    "footer{max-width:46rem;margin:2.5rem auto 2rem;padding:0 1rem;color:var(--soft);font-size:.9rem}"
    "@media (max-width:40rem){body{font-size:1rem}.formula{margin-left:.3rem}"
    ".formula.long{display:block}.formula.long .right{padding-left:2.8em}th,td{padding:.35rem .5rem}}"
    "@media print{:root{--ink:#000;--paper:#fff;--soft:#333;--faint:#777;--tint:#f4f4f4;--curve:#0b5394;"
    "--result:#a3241d;--second:#1c6b34}nav{display:none}body{font-size:10.5pt}.wide,.formula{overflow:"
    "visible}"
    "h2{break-after:avoid}.holds,.fails{break-before:avoid}figure,tr,.formula{break-inside:avoid}details{"
    "display:none}"
    "svg.pyramid{max-width:100%;height:auto}}";

}  // namespace

pugi::xml_node append_words(pugi::xml_node parent, const char* element, const std::string& words) {
    pugi::xml_node node = parent.append_child(element);
    node.text().set(words.c_str());
    return node;
}

HtmlPage::HtmlPage(const std::string& title) {
    document_.append_child(pugi::node_doctype).set_value("html");
    pugi::xml_node html = document_.append_child("html");
    html.append_attribute("lang") = "en";
    pugi::xml_node head = html.append_child("head");
    head.append_child("meta").append_attribute("charset") = "utf-8";
    pugi::xml_node viewport = head.append_child("meta");
    viewport.append_attribute("name") = "viewport";
    viewport.append_attribute("content") = "width=device-width, initial-scale=1";
    append_words(head, "title", title);
    append_words(head, "style", svg_style() + page_style);
    body_ = html.append_child("body");
    main_ = body_.append_child("main");
}

void HtmlPage::append_navigation(const std::vector<Link>& links) {
    if (links.empty()) return;
    pugi::xml_node navigation = body_.insert_child_before("nav", main_);
    for (const Link& link : links) {
        append_words(navigation, "a", link.text).append_attribute("href") = link.target.c_str();
    }
}

std::string HtmlPage::text() const { return markup_of(document_) + "\n"; }

}  // namespace blossom::worked
