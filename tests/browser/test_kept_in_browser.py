"""Nothing is lost in the app: reload, Back, undo, a link, named studies, and a server that was started again."""

from __future__ import annotations

import pytest

from conftest import AppPage, free_port, served

pytestmark = pytest.mark.browser

FORCE, RADIUS = "problem.load.force", "problem.bed.profile.curvature_radius"


def number(app_page, path):
    return app_page.page.locator(f'input[data-path="{path}"]').input_value()


def depth_of(app_page, force):
    """Wait until the sentence at the top names a force."""
    lead = app_page.page.locator(".head .sought-line", has_text=f"under a force of {force}")
    lead.wait_for(timeout=30_000)
    return lead.inner_text()


def test_reload_back_undo_and_a_link(fresh):
    app_page = fresh()
    page = app_page.page
    assert "#" not in page.url
    app_page.type(FORCE, "200 N")
    sentence = depth_of(app_page, "200 N")
    page.wait_for_function("location.hash.startsWith('#study=')")

    page.reload()
    app_page.settled()
    assert number(app_page, FORCE) == "200 N"
    assert depth_of(app_page, "200 N") == sentence

    app_page.choose("problem.bed.profile", "paraboloid")
    page.locator('[data-choice="problem.bed.profile"]', has_text="paraboloid").wait_for()
    app_page.busy()
    app_page.settled()
    page.go_back()
    page.locator('[data-choice="problem.bed.profile"]', has_text="sphere").wait_for()
    assert number(app_page, FORCE) == "200 N"
    page.go_forward()
    page.locator('[data-choice="problem.bed.profile"]', has_text="paraboloid").wait_for()

    app_page.type(FORCE, "300 N")
    depth_of(app_page, "300 N")
    page.locator('[data-kept="undo"]').click()
    depth_of(app_page, "200 N")
    assert number(app_page, FORCE) == "200 N"
    page.locator("h1").click()  # away from buttons and fields
    page.keyboard.press("Control+Shift+z")
    depth_of(app_page, "300 N")
    page.keyboard.press("Control+z")
    depth_of(app_page, "200 N")

    page.wait_for_function("sessionStorage.getItem('winkler.study').includes(location.hash.slice(7))")
    other = fresh()
    other.page.goto("about:blank")
    other.page.goto(page.url)
    other.settled()
    assert number(other, FORCE) == "200 N"
    assert "paraboloid" in other.page.locator('[data-choice="problem.bed.profile"]').inner_text()

    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.locator('[data-kept="copy-link"]').click()
    page.get_by_text("The link to this study is copied.").wait_for()
    assert page.evaluate("navigator.clipboard.readText()") == page.url
    plain = page.url.partition("#")[0]
    page.goto("about:blank")
    page.goto(plain)  # without a study in it: the tab has kept its own
    app_page.settled()
    assert number(app_page, FORCE) == "200 N"


def test_named_studies_and_a_link_that_was_cut(fresh):
    app_page = fresh()
    page = app_page.page
    app_page.type(FORCE, "50 N")
    depth_of(app_page, "50 N")
    page.locator('[data-kept="named"]').click()
    page.get_by_label("Keep this study as").fill("half <b>load</b>")
    page.get_by_role("button", name="Keep", exact=True).click()
    page.get_by_role("button", name="half <b>load</b>", exact=True).wait_for()
    page.keyboard.press("Escape")
    app_page.type(FORCE, "70 N")
    depth_of(app_page, "70 N")
    page.reload()
    app_page.settled()
    page.locator('[data-kept="named"]').click()
    page.get_by_role("button", name="half <b>load</b>", exact=True).click()
    depth_of(app_page, "50 N")

    whole = page.url
    page.goto("about:blank")
    page.goto(whole[:-20])
    page.get_by_text("The address holds no whole study").wait_for(timeout=20_000)
    app_page.settled()
    assert number(app_page, FORCE) == "100 N"  # the example, in place of half a study


def test_a_server_that_was_started_again_takes_up_the_page(browser):
    port = free_port()
    with served(port=port, crashes=True) as address:
        app_page = AppPage(browser, address)
        app_page.type(FORCE, "20 N")
        sentence = depth_of(app_page, "20 N")
        app_page.page.wait_for_function("location.hash.startsWith('#study=')")
        field = app_page.page.locator(f'input[data-path="{FORCE}"]')
        field.focus()
    app_page.page.get_by_text("Connection lost").wait_for(timeout=20_000)
    app_page.page.keyboard.press("End")
    app_page.page.keyboard.type("7")  # nobody would take it, and the field would silently go back
    field.focus()
    app_page.page.keyboard.type("7")
    assert field.input_value() == "20 N"
    app_page.page.evaluate("document.querySelector('.head').remove()")  # what shows it later is a new page
    with served(port=port, crashes=True):
        assert depth_of(app_page, "20 N") == sentence
        assert number(app_page, FORCE) == "20 N"
        app_page.type(FORCE, "30 N")
        depth_of(app_page, "30 N")
        assert app_page.left_machine == []
        app_page.page.context.close()
