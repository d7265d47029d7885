document.body.textContent = "carom";
