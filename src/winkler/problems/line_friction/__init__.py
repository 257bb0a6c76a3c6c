"""Friction of line contacts: stick and slip with memory, and bulk stress beside a contact that frets."""
