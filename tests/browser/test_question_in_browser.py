"""The question changes and the bodies stay; what stands first is what was asked."""

from __future__ import annotations

import html

import pytest

from winkler.web.form.front_examples import FRONT_EXAMPLES

pytestmark = pytest.mark.browser

FORCE, FIRST = "problem.load.force", "problem.bed.medium.first"
OTHER_SENTENCE = """before => {
  const one = document.querySelector('.head .sought-line');
  return document.querySelector('.answer-side').dataset.state === 'wrong' || (one && one.innerText !== before);
}"""


FIRST_SHOWN = """label => {
  const shown = [...document.querySelectorAll('[role=option]')].filter(one => one.offsetHeight);
  shown.sort((one, two) => one.getBoundingClientRect().top - two.getBoundingClientRect().top);
  return shown[0]?.getAttribute('aria-label') === label;
}"""


def test_another_question_for_the_same_bodies(fresh):
    app_page = fresh()
    page = app_page.page
    app_page.type("problem.bed.profile.curvature_radius", "5 mm")
    app_page.type(FORCE, "40 N")
    page.locator(".head .sought-line", has_text="under a force of 40 N").wait_for(timeout=30_000)
    app_page.settled()
    app_page.choose("problem", "elliptic_indentation")
    page.get_by_text("Dropped, as elliptic indentation has no place for it: profile (sphere 5 mm).").wait_for()
    app_page.busy()
    app_page.settled()
    assert page.locator(f'input[data-path="{FORCE}"]').input_value() == "40 N"
    assert page.locator(".head .card.sought .name").first.inner_text().startswith("peak pressure")
    app_page.shot("another_question")
    page.get_by_role("button", name="Take the example instead").click()
    page.locator(".head .sought-line", has_text="under a force of 100 N").wait_for(timeout=30_000)
    page.locator('[data-kept="undo"]').click()
    page.locator(".head .sought-line", has_text="under a force of 40 N").wait_for(timeout=30_000)


def test_numbers_of_an_example_are_marked_until_they_are_typed_and_a_link_keeps_the_marks(fresh):
    app_page = fresh()
    page, strength = app_page.page, "problem.bed.medium.first.strength"

    def is_marked(shown, path):
        return shown.locator(f'.entry.assumed:has(input[data-path="{path}"])').count() == 1

    assert is_marked(page, FORCE)
    assert "Not yours, but an example's" in page.locator(".head p.assumed").inner_text()
    app_page.type(FORCE, "40 N")
    page.locator(".head .sought-line", has_text="under a force of 40 N").wait_for(timeout=30_000)
    page.locator(f'.entry:not(.assumed):has(input[data-path="{FORCE}"])').wait_for()
    app_page.choose("problem", "yield_onset")
    page.locator(".head p.assumed", has_text="strength 700 MPa").wait_for(timeout=30_000)
    app_page.settled()
    assert is_marked(page, strength)
    page.wait_for_function("sessionStorage.getItem('winkler.study').includes(location.hash.slice(7))")
    other = fresh()
    other.page.goto("about:blank")
    other.page.goto(page.url)
    other.page.locator(".head p.assumed", has_text="strength 700 MPa").wait_for(timeout=30_000)
    assert is_marked(other.page, strength)
    other.type(strength, "900 MPa")
    other.page.locator(f'.entry:not(.assumed):has(input[data-path="{strength}"])').wait_for()
    other.settled()
    assert "strength" not in other.page.locator(".head p.assumed").inner_text()
    app_page.shot("assumed")


def test_the_worst_doubt_says_what_to_do(fresh):
    app_page = fresh()
    head = app_page.page.locator(".head")
    assert head.locator(".standing-line").inner_text().startswith("good to about")
    assert head.locator(".card.sought").count() == 1
    app_page.type(FORCE, "100 kN")
    doubt = app_page.page.locator(".head .doubt", has_text="What to do: press less")
    doubt.wait_for(timeout=30_000)
    assert "use at most" in doubt.inner_text()
    assert head.locator(".standing-line").inner_text().startswith("an estimate: ±")
    app_page.type("problem.bed.medium.first.strength", "700 MPa")
    card = app_page.page.locator(".head .beside .card", has_text="load at which it yields")
    card.get_by_text("of the first body, by von Mises' criterion").wait_for(timeout=30_000)
    assert head.locator(".standing-line").inner_text() == "do not use"
    assert head.locator(".card.sought").count() == 0
    app_page.shot("doubt")


def test_the_page_begins_with_examples(fresh):
    app_page = fresh()
    page = app_page.page
    assert page.locator(".front-card").count() == 16
    assert page.locator(".front-questions .front-card").count() == 8
    words = page.locator(".study-side").inner_text()
    for slot in (
        "bed: shape and bodies",
        "profile: what presses",
        "medium: the bodies",
        "first: into what",
        "load: how hard",
        "second: of what the pressing body is made",
    ):
        assert slot in words
    assert page.locator('[data-choice="problem.bed.medium.second"]').inner_text() == "elastic"  # steel on steel
    page.get_by_role("button", name="Ball bearing").click()
    page.locator(".head .sought-line", has_text="The peak pressure is 1.791 GPa, on a contact of semi-axes").wait_for()
    assert not page.locator(".front").is_visible()
    page.locator('[data-kept="examples"]').click()
    page.get_by_role("button", name="AFM bead on a gel").click()
    page.locator(".head .sought-line", has_text="under a force of 1 nN").wait_for(timeout=60_000)
    second = page.locator('[data-choice="problem.bed.medium.second"]')
    assert second.inner_text() == "— rigid"
    app_page.settled()
    page.go_back()
    page.locator(".head .sought-line", has_text="under a force of 500 N").wait_for(timeout=30_000)
    app_page.choose("problem", "line_indentation")
    page.get_by_text("Kept: medium (half space).").wait_for(timeout=30_000)
    titles = [one.title for one in FRONT_EXAMPLES]
    for title in titles:
        before = page.locator(".head .sought-line").inner_text()
        page.locator('[data-kept="examples"]').click()
        page.get_by_role("button", name=title).click()
        page.wait_for_function(OTHER_SENTENCE, arg=before, timeout=60_000)
        assert not page.locator(".refused").is_visible(), title


def test_an_answer_without_stresses_says_why(fresh):
    app_page = fresh()
    page = app_page.page
    app_page.choose("problem", "fretting_wear")
    page.locator(".head .beside", has_text="indentation states them before wear").wait_for(timeout=60_000)
    app_page.settled()
    app_page.choose("problem", "joule_heating")
    page.locator(".head .sought-line", has_text="above that of the bodies").wait_for(timeout=60_000)
    app_page.settled()
    page.set_viewport_size({"width": 390, "height": 844})
    assert app_page.overflow() == []
    app_page.shot("no_stresses")


def test_a_kind_is_found_by_its_name_or_by_words(fresh):
    """By the keyboard alone; the list is whole again when it is opened next."""
    app_page = fresh()
    page = app_page.page
    page.locator('[data-choice="problem"]').click()
    page.get_by_role("searchbox", name="Find by name, chapter, word or question").wait_for()
    page.keyboard.type("adhes cycle")
    page.wait_for_function("[...document.querySelectorAll('[role=option]')].filter(o => o.offsetHeight).length < 6")
    page.wait_for_function(FIRST_SHOWN, arg="adhesive cycle")
    page.keyboard.press("Enter")
    app_page.busy()
    app_page.settled()  # what comes while the list is open has a test of its own
    assert page.locator('[data-choice="problem"]').inner_text().endswith("adhesive cycle")
    page.locator('[data-choice="problem"]').click()
    page.wait_for_function("[...document.querySelectorAll('[role=option]')].filter(o => o.offsetHeight).length > 40")
    page.keyboard.type("qqqqxx")
    page.get_by_text("Nothing has these words.").wait_for()
    page.keyboard.press("Control+A")
    page.keyboard.type("does my gasket leak")
    app_page.shot("found_by_words")
    page.wait_for_function(FIRST_SHOWN, arg="seal")
    page.keyboard.press("Control+A")
    page.keyboard.type("oil film thickness")
    page.get_by_text("winkler does not cover lubricant films.").wait_for()
    page.wait_for_function(FIRST_SHOWN, arg="indentation")
    app_page.shot("not_covered")
    page.keyboard.press("Control+A")
    page.keyboard.type("does my gasket leak")
    page.wait_for_function(FIRST_SHOWN, arg="seal")
    page.keyboard.press("Enter")
    page.locator('[data-choice="problem"]', has_text="seal").wait_for()


ANEW = """() => {
  const select = mounted_app.elements[document.querySelector('[data-choice="problem"]').id.slice(1)];
  select.props = { ...select.props, options: select.props.options.map(one => ({ ...one })) };
}"""


def test_a_list_that_is_made_anew_keeps_what_was_found(fresh):
    """The form is rebuilt when the answer to an earlier choice comes, which a slow machine sends after the search."""
    page = fresh().page
    page.locator('[data-choice="problem"]').click()
    page.get_by_role("searchbox", name="Find by name, chapter, word or question").wait_for()
    page.keyboard.type("does my gasket leak")
    page.wait_for_function(FIRST_SHOWN, arg="seal")
    page.evaluate("window.earlier = document.querySelector('[role=option]')")
    page.evaluate(ANEW)
    page.wait_for_function("!window.earlier.isConnected")
    page.wait_for_function(FIRST_SHOWN, arg="seal", timeout=10_000)
    page.keyboard.press("Enter")
    page.locator('[data-choice="problem"]', has_text="seal").wait_for()


def test_no_question_changes_what_was_typed_or_chosen(fresh):
    """Two balls of steel are no ball and a rigid plate; what was typed comes back, what an example lent goes."""
    app_page = fresh()
    page, young, strength = app_page.page, f"{FIRST}.young", f"{FIRST}.strength"
    app_page.choose("problem", "yield_onset")
    page.locator(".head .sought-line", has_text="55.8").wait_for(timeout=60_000)
    assert page.locator('[data-choice="problem.bed.medium.second"]').inner_text() == "elastic"
    app_page.settled()
    app_page.type(young, "70 GPa")
    page.locator(f'.entry:not(.assumed):has(input[data-path="{young}"])').wait_for()
    app_page.busy()
    app_page.settled()
    for question in ("line_rolling", "viscoelastic_indentation", "indentation"):
        before = page.locator(".head .sought-line").inner_text()
        app_page.choose("problem", question)
        page.wait_for_function(OTHER_SENTENCE, arg=before, timeout=60_000)
        app_page.settled()
    assert page.locator(f'input[data-path="{young}"]').input_value() == "70 GPa"
    assert page.locator(f'input[data-path="{strength}"]').input_value() == ""
    assert page.locator(f'.entry.assumed:has(input[data-path="{young}"])').count() == 0
    app_page.choose("problem.bed.profile", "cone")
    app_page.busy()
    app_page.settled()
    app_page.choose("problem.bed.profile", "sphere")
    page.locator('input[data-path="problem.bed.profile.curvature_radius"]').wait_for()
    app_page.settled()
    app_page.shot("nothing_changed")


def test_a_file_a_text_and_a_report_keep_whose_numbers_they_are(fresh, tmp_path):
    app_page = fresh()
    page = app_page.page
    app_page.type(FORCE, "40 N")
    page.locator(".head .sought-line", has_text="under a force of 40 N").wait_for(timeout=30_000)
    app_page.settled()
    sentence = "Not yours, but an example's: curvature radius 10 mm"
    assert sentence in html.unescape(app_page.taken("report").decode()).replace("\xa0", " ")
    study = tmp_path / "study.toml"
    study.write_bytes(app_page.taken("study"))
    page.get_by_text("The study as text").click()
    area = page.get_by_role("textbox", name="The study as text")
    area.fill(area.input_value().replace("10 mm", "8 mm"))
    page.get_by_role("button", name="Use this text").click()
    page.locator(".head p.assumed", has_text="Not yours, but an example's: Young's modulus 210 GPa").wait_for()
    app_page.settled()
    other = fresh()
    other.page.locator('input[type="file"]').first.set_input_files(study)
    other.page.locator(".head .sought-line", has_text="under a force of 40 N").wait_for(timeout=30_000)
    assert sentence in other.page.locator(".head p.assumed").inner_text().replace("\xa0", " ")
    assert other.page.locator(f'.entry.assumed:has(input[data-path="{FORCE}"])').count() == 0


def test_a_range_that_the_page_proposes_is_marked_until_it_is_changed(fresh):
    app_page = fresh()
    page = app_page.page
    page.locator('[data-fold="sweep"]').click()
    app_page.pick("sweep", "load › force")
    page.locator(".head p.assumed", has_text="force from 50 N to 200 N").wait_for(timeout=60_000)
    app_page.settled()
    frame = page.locator('.part:has(> div input[data-path="sweep.problem.load.force.from"])')
    assert "assumed" in (frame.last.get_attribute("class") or "")
    app_page.shot("range_proposed")
    app_page.type("sweep.problem.load.force.from", "20 N")
    page.locator('.part.free:not(.assumed) input[data-path="sweep.problem.load.force.from"]').wait_for()
    page.wait_for_function("!document.querySelector('.head p.assumed').innerText.includes('from 50 N')")
